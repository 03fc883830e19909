#include "certify/covered_parts.h"

#include <optional>
#include <vector>

#include "certify/distance_bounds.h"
#include "certify/tube.h"
#include "certify/winding_number.h"
#include "geometry/files/text_lines.h"
#include "geometry/kd_tree.h"

namespace morskin::certify {

namespace {

/// A margin far above the rounding of the few operations that it follows.
constexpr double up = 1 + 1e-6;

/// A point that a path from a triangle to the surface may pass; nothing if there is none.
std::optional<std::size_t> point_on_path(const LocatedMesh& mesh,
                                         const std::vector<Point>& points) {
  const geometry::KdTree<geometry::VertexId> tree(points);
  std::optional<std::size_t> found;
  for (const auto& triangle : mesh.mesh.triangles) {
    const TriangleBounds shape = mesh.shape(triangle);
    const LocatedMesh::CornerPoints points_at = mesh.corners(triangle);
    const Corners corners = points_at;
    const CornerBounds bounds = mesh.corner_bounds(triangle);
    const double R = shape.circumradius;
    // |N| is 1-Lipschitz and falls along a path, whose length it bounds: few points are so near.
    const double longest = max_length_scale(corners) + bounds.max_error + R;
    const Point& corner = mesh.position(triangle[0]);
    tree.for_each_within(corner, up * (2 * R + longest), [&](const auto& near) {
      const double path = up * prove_tube(mesh.surface, corners, shape, bounds).max_path;
      Offsets offsets;
      for (std::size_t k = 0; k < 3; ++k) {
        offsets[k] = mesh.position(triangle[k]) - points[near.id.index()];
      }
      if (!(distance_below(offsets) > path)) found = near.id.index();
    });
  }
  return found;
}

}  // namespace

std::string objection_to_parts(const LocatedMesh& mesh, const surface::Topology& expected) {
  std::vector<Point> points = expected.inside;
  points.insert(points.end(), expected.outside.begin(), expected.outside.end());
  if (const auto near = point_on_path(mesh, points)) {
    return "a triangle is too near to " + geometry::in_words(points[*near]) +
           " to tell what it bounds there";
  }
  // None lies on the mesh, for all are farther from each triangle than its path is long.
  const std::vector<int> windings = winding_numbers(mesh.mesh, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_inside = i < expected.inside.size();
    if (windings[i] == (is_inside ? 1 : 0)) continue;
    return "others than the components to be meshed: the mesh should " +
           std::string(is_inside ? "go once" : "not go") + " round " +
           geometry::in_words(points[i]);
  }
  return "";
}

}  // namespace morskin::certify
