#pragma once

/// What Figures 5 to 8 share: one real sweep of the cube of Figure 4, and its states as scenes.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/bundled.h"
#include "app/figures/recorded_sweep.h"
#include "app/figures/skin_scene.h"
#include "certify/sizing.h"
#include "front/tangent_disk.h"

namespace morskin::figures {

struct Stage {
  morskin::PreparedSkin skin = bundled_skin("cube8.xyzr", skin::Model::Paper, 0);
  RecordedSweep sweep = recorded_sweep(skin, {.sizing = {.C = 0.08}});
  MeshLayer bare = backdrop(skin, sweep.guide.function, 0.03);
  double disk_share = front::Spacing{}.disk_share * certify::Sizing{}.tangent_disk_share();

  std::array<geometry::VertexId, 3> corners(std::size_t triangle) const {
    return sweep.mesh.surface.corners(geometry::TriangleId{triangle});
  }
  const surface::SurfacePoint& at(geometry::VertexId v) const { return sweep.mesh.at(v); }
};

/// The triangles of an operation as a fan: its centre, and the rim in order.
struct Fan {
  geometry::VertexId centre;
  std::vector<geometry::VertexId> rim;
};

/// Of an operation whose triangles have one vertex in common and no two rims, else nothing.
std::optional<Fan> fan_of(const Stage& stage, const Event& event);

/// Whether two vertices were the ends of a front edge when there were so many triangles.
class FrontBefore {
 public:
  FrontBefore(const Stage& stage, std::size_t triangles)
      : edges_(pictures::boundary_edges(skin_layer(stage.sweep.mesh, triangles).mesh)) {}
  bool has(geometry::VertexId a, geometry::VertexId b) const {
    return std::ranges::binary_search(
        edges_, std::array{std::min(a.value, b.value), std::max(a.value, b.value)});
  }
  /// The other end of the front edge at `a` that does not go to `b`.
  std::optional<geometry::VertexId> other(geometry::VertexId a, geometry::VertexId b) const {
    for (const auto& [from, to] : edges_) {
      if (from == a.value && to != b.value) return geometry::VertexId{to};
      if (to == a.value && from != b.value) return geometry::VertexId{from};
    }
    return std::nullopt;
  }

 private:
  std::vector<std::array<std::uint32_t, 2>> edges_;
};

/// Where the rim of a tangent disk lies in the direction of a point.
Point on_rim(const surface::SurfacePoint& centre, double radius, const Point& p);

/// The state after a number of triangles, those from `fresh` on highlighted, the front in red.
Scene state(const Stage& stage, std::size_t triangles, std::size_t fresh);

/// A circle about a point of the skin; its plane is that of two orthogonal vectors.
pictures::Line circle(const Point& centre, double radius, const Vector& first, const Vector& second,
                      double dash);
pictures::Line tangent_disk(const Stage& stage, const surface::SurfacePoint& p);

/// A camera over a point of the skin, the Morse function rising upwards in the picture.
Camera over(const Stage& stage, const surface::SurfacePoint& p, double half_width, double tilt);

void add_vertex(Scene& scene, const Point& p, const std::string& text, const Vector2& shift,
                double radius, const Colour& colour = pictures::ink);

/// The position of a label away from a centre in the view.
Vector2 outward(const Camera& camera, const Point& centre, const Point& p, double pixels);

/// The meaning of the colours of a state, but for skin_blue, that of the triangles laid before.
/// @param dashes  what is dashed
std::vector<LegendEntry> state_legend(std::string dashes);

Image before_and_after(const Scene& before, const Scene& after, const Camera& camera,
                       std::array<std::string_view, 2> captions, std::string dashes, double scale);

/// Of the events of one kind that `suits`, the one at a share of their number.
template <class Suits>
const Event& chosen(const Stage& stage, front::Operation operation, double share,
                    const Suits& suits) {
  std::vector<const Event*> events;
  for (const Event& e : stage.sweep.events) {
    if (e.operation == operation && suits(e)) events.push_back(&e);
  }
  if (events.empty()) throw std::logic_error("the sweep has no operation for this figure");
  const double position = share * static_cast<double>(events.size() - 1);
  return *events[static_cast<std::size_t>(position)];
}

}  // namespace morskin::figures
