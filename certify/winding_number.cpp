#include "certify/winding_number.h"

#include <array>

#include "geometry/exact_positions.h"
#include "geometry/kd_tree.h"
#include "geometry/predicates.h"

namespace morskin::certify {

namespace {

using geometry::Point;
using geometry::Sign;
using Corners = std::array<Point, 3>;

/// How often the triangle, seen from above, goes round p: 1, -1 or 0. Of a horizontal line through
/// p an edge counts where it crosses it to the right of p.
int turns_about(const Point& p, const Corners& triangle) {
  constexpr double top = 0x1p30;  // of the range of the exact predicates: no triangle is above it
  const Point above(p.x(), p.y(), top);
  int turns = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &a = triangle[k], &b = triangle[k == 2 ? 0 : k + 1];
    const bool is_upwards = a.y() <= p.y() && b.y() > p.y();
    const bool is_downwards = a.y() > p.y() && b.y() <= p.y();
    if (!is_upwards && !is_downwards) continue;
    const Sign side = geometry::orientation(a, b, above, p);
    if (is_upwards && side == Sign::Positive) ++turns;
    if (is_downwards && side == Sign::Negative) --turns;
  }
  return turns;
}

Point projected(const Point& p) { return {p.x(), p.y(), 0}; }

}  // namespace

std::vector<int> winding_numbers(const geometry::IndexedMesh& mesh, std::span<const Point> points) {
  std::vector<Point> all(mesh.positions.begin(), mesh.positions.end());
  all.insert(all.end(), points.begin(), points.end());
  const geometry::ExactPositions exact(all);
  const std::span<const Point> asked = exact.all().last(points.size());
  std::vector<Point> in_plane;
  for (const Point& p : asked) in_plane.push_back(projected(p));
  const geometry::KdTree<geometry::VertexId> tree(in_plane);
  std::vector<int> windings(points.size(), 0);
  for (const auto& [i, j, k] : mesh.triangles) {
    const Corners triangle{exact[i], exact[j], exact[k]};
    const Point low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
    const Point high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
    constexpr double rounded_up = 1 + 0x1p-40;
    const double reach = rounded_up * projected(high - low).norm();
    tree.for_each_within(projected(low), reach, [&](const auto& near) {
      const Point& p = asked[near.id.index()];
      const int turns = turns_about(p, triangle);
      if (turns == 0) return;
      const Sign side = geometry::orientation(triangle[0], triangle[1], triangle[2], p);
      const bool is_above = side == (turns > 0 ? Sign::Positive : Sign::Negative);
      if (is_above) windings[near.id.index()] += turns;
    });
  }
  return windings;
}

}  // namespace morskin::certify
