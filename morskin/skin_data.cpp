// What the library's face tells of a skin beside meshes: of its points, and of heights on it.

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "certify/located_vertices.h"
#include "geometry/mesh_shape.h"
#include "morskin/boundary.h"
#include "morskin/traced_complex.h"
#include "skin/atom_shares.h"
#include "skin/curvatures.h"

namespace morskin {

namespace {

using morskin::outside;  // not hidden by those below

SkinPoint outside(const skin::SkinSurface& skin, const surface::SurfacePoint& x,
                  std::uint32_t component) {
  const auto [curvatures, directions] =
      skin.with_patch(x.cell, [&](const skin::Patch& patch) { return skin::curvatures(patch, x); });
  const bool is_second_larger = std::abs(curvatures[1]) > std::abs(curvatures[0]);
  const std::size_t first = is_second_larger ? 1 : 0, second = 1 - first;
  SkinPoint result{.normal = outside(x.normal),
                   .length_scale = x.length_scale,
                   .curvatures = {curvatures[first], curvatures[second]},
                   .directions = {outside(directions[first]), outside(directions[second])},
                   .atom = skin.nearest_atom(x.position, x.cell).value,
                   .atoms = {-1, -1, -1, -1},
                   .shares = {},
                   .component = component};
  const skin::AtomShares shares = skin::atom_shares(skin, x);
  for (std::size_t i = 0; i < shares.size; ++i) {
    result.atoms[i] = static_cast<std::int32_t>(shares.atoms[i].value);
    result.shares[i] = shares.shares[i];
  }
  return result;
}

std::vector<CriticalPoint> outside(const std::vector<morse::CriticalPoint>& points) {
  std::vector<CriticalPoint> result;
  result.reserve(points.size());
  for (const morse::CriticalPoint& p : points) {
    result.push_back({outside(p.point.position), p.index, p.value});
  }
  return result;
}

MorseSmaleComplex outside(const morse::MorseSmaleComplex& complex) {
  MorseSmaleComplex result;
  result.points = outside(complex.points);
  for (const morse::Arc& arc : complex.arcs) {
    result.arcs.push_back({arc.saddle.value, arc.extremum.value});
  }
  result.arc_points.reserve(complex.line_points.size());
  for (const geometry::Point& p : complex.line_points) result.arc_points.push_back(outside(p));
  result.arc_offsets = complex.first_point;
  for (const auto& [a, b, c, d] : complex.regions) {
    result.regions.push_back({a.value, b.value, c.value, d.value});
  }
  return result;
}

std::optional<morse::MorseFunction> height_along(const std::optional<Point>& direction) {
  if (!direction) return std::nullopt;
  return morse::MorseFunction::height(inside(*direction));
}

}  // namespace

std::vector<SkinPoint> Skin::points(const TriangleMesh& mesh) const {
  return with_errors([&] {
    const geometry::IndexedMesh from = inside(mesh);
    const skin::SkinSurface& surface = prepared_->skin.surface;
    const std::vector<std::uint32_t> component = geometry::vertex_components(from);
    const std::vector<surface::SurfacePoint> points = certify::locate_vertices(from, surface);
    std::vector<SkinPoint> result;
    result.reserve(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      result.push_back(outside(surface, points[v], component[v]));
    }
    return result;
  });
}

std::vector<CriticalPoint> Skin::critical_points(const std::optional<Point>& direction) const {
  return with_errors([&] {
    const PreparedSkin& skin = prepared_->skin;
    return outside(choose_function(skin, height_along(direction)).critical.points);
  });
}

MorseSmaleComplex Skin::morse_smale(const std::optional<Point>& direction,
                                    const RunOptions& run) const {
  return with_errors([&] {
    return outside(trace_complex(prepared_->skin, height_along(direction), inside(run)).complex);
  });
}

}  // namespace morskin
