// Figure 7: a small front angle, what creep would do beside it, and the wing that closes it.

#include <Eigen/Geometry>
#include <cmath>

#include "app/figures/figures.h"
#include "app/figures/operations_scene.h"

namespace morskin::figures {
namespace {

using front::Operation;
using geometry::VertexId;
using surface::SurfacePoint;

// A small angle g f d of the front, and the creep at d that leaves it small.
struct SmallAngle {
  VertexId g, f, d, next;          // next: the front's other vertex at d
  std::vector<SurfacePoint> laid;  // new vertices, the first beside f
};

// The new vertices of a creep at d, whose bare angle goes counterclockwise between two neighbours.
std::vector<SurfacePoint> creep_at(const Stage& stage, VertexId d, VertexId from, VertexId to) {
  const SurfacePoint& p = stage.at(d);
  const Vector side = stage.at(from).position - p.position,
               end = stage.at(to).position - p.position;
  const Vector first = (side - side.dot(p.normal) * p.normal).normalized();
  const Vector second = p.normal.cross(first);
  double bare = std::atan2(end.dot(second), end.dot(first));
  if (bare <= 0) bare += 2 * M_PI;
  const double count = std::max(1.0, std::round(bare / (M_PI / 3)));
  const double r = stage.disk_share * p.length_scale;
  std::vector<SurfacePoint> result;
  for (double i = 1; i < count; ++i) {
    const double angle = bare * i / count;
    const Vector direction = std::cos(angle) * first + std::sin(angle) * second;
    const auto x = stage.skin.surface.project(p.position + r * direction, p.cell);
    if (!x) return {};
    result.push_back(*x);
  }
  return result;
}

// Of a wing whose angle, left as it was, would have let the creep beside it overlap the mesh.
std::optional<SmallAngle> overlapping(const Stage& stage, const Event& wing) {
  const FrontBefore front(stage, wing.before);
  auto c = stage.corners(wing.before);
  for (int i = 0; i < 2 && !(front.has(c[0], c[1]) && front.has(c[0], c[2])); ++i) {
    std::rotate(c.begin(), c.begin() + 1, c.end());
  }
  const auto next = front.other(c[2], c[0]);
  if (!next) return std::nullopt;
  SmallAngle result{c[1], c[0], c[2], *next, creep_at(stage, c[2], c[0], *next)};
  if (result.laid.size() < 2) return std::nullopt;
  // The mesh lies to the left of the edge from g to f.
  const Point& g = stage.at(result.g).position;
  const SurfacePoint& f = stage.at(result.f);
  const double left =
      (f.position - g).cross(result.laid[0].position - g).dot(f.normal) / (f.position - g).norm();
  return left > 0.12 * stage.disk_share * f.length_scale ? std::optional(result) : std::nullopt;
}

// Adds the creep's triangles, raised a little so that those below do not hide the overlap.
void add_creep(Scene& scene, const Stage& stage, const SmallAngle& angle, double raised) {
  MeshLayer fan;
  std::vector<SurfacePoint> rim{stage.at(angle.f)};
  rim.insert(rim.end(), angle.laid.begin(), angle.laid.end());
  rim.push_back(stage.at(angle.next));
  rim.push_back(stage.at(angle.d));
  for (const SurfacePoint& p : rim) fan.mesh.positions.push_back(p.position + raised * p.normal);
  const auto centre = static_cast<std::uint32_t>(rim.size() - 1);
  for (std::uint32_t i = 0; i + 1 < centre; ++i) fan.mesh.triangles.push_back({centre, i, i + 1});
  fan.coat.colour = fan.coat.back = fresh_orange;
  fan.coat.edge_width = 1.8;
  scene.meshes.push_back(std::move(fan));
}

}  // namespace

Image wing(double scale) {
  const Stage stage;
  const Event& event = chosen(stage, Operation::Wing, 0.8,
                              [&](const Event& e) { return overlapping(stage, e).has_value(); });
  const SmallAngle angle = *overlapping(stage, event);
  const SurfacePoint& f = stage.at(angle.f);
  const double r = stage.disk_share * f.length_scale;
  const Camera camera = over(stage, f, 2.6 * r, 0.45);
  Scene before = state(stage, event.before, event.before);
  Scene after = state(stage, event.after, event.before);
  add_creep(before, stage, angle, 0.04 * r);
  before.lines.push_back(tangent_disk(stage, stage.at(angle.d)));
  for (Scene* scene : {&before, &after}) {
    add_vertex(*scene, f.position, "f", Vector2(0, 30), 0.06 * r);
    for (const auto& [vertex, name] : {std::pair{angle.g, "g"}, std::pair{angle.d, "d"}}) {
      const Point& x = stage.at(vertex).position;
      add_vertex(*scene, x, name, outward(camera, f.position, x, 22), 0.05 * r);
    }
  }
  const std::size_t count = angle.laid.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& x = angle.laid[i].position;
    add_vertex(before, x, "p_" + std::to_string(count - 1 - i),
               outward(camera, stage.at(angle.d).position, x, 22), 0.05 * r);
  }
  return before_and_after(before, after, camera,
                          {"(a) creep at d, the angle at f left", "(b) after wing"}, "tangent disk",
                          scale);
}

}  // namespace morskin::figures
