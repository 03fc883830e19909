#include "morse/overlaps.h"

#include <algorithm>

#include "geometry/kd_tree.h"

namespace morskin::morse {

std::vector<double> full_radii(const std::vector<CriticalPoint>& points, double radius_share) {
  std::vector<double> radii;
  radii.reserve(points.size());
  for (const CriticalPoint& p : points) radii.push_back(radius_share * p.point.length_scale);
  return radii;
}

std::vector<std::pair<CriticalId, CriticalId>> overlapping_spheres(
    const std::vector<CriticalPoint>& points, const std::vector<double>& radii) {
  using Tree = geometry::KdTree<CriticalId>;
  std::vector<Point> centres;
  centres.reserve(points.size());
  for (const CriticalPoint& p : points) centres.push_back(p.point.position);
  const Tree tree(centres);
  std::vector<std::pair<CriticalId, CriticalId>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(radii[i] > 0)) continue;
    // The larger sphere of a pair finds the smaller, whose centre lies within two of its radii.
    const std::pair own(radii[i], CriticalId{i});
    tree.for_each_within(centres[i], 2 * radii[i], [&](const Tree::Neighbour& other) {
      const double radius = radii[other.id.index()], radii_sum = radii[i] + radius;
      if (radius > 0 && std::pair(radius, other.id) < own &&
          other.squared_distance < radii_sum * radii_sum) {
        pairs.emplace_back(std::minmax(own.second, other.id));
      }
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<double> shrunk_apart(
    const std::vector<CriticalPoint>& points, const std::vector<double>& radii,
    const std::vector<std::pair<CriticalId, CriticalId>>& overlapping) {
  std::vector<double> result = radii;
  for (const auto& [a, b] : overlapping) {
    const double apart =
        (points[a.index()].point.position - points[b.index()].point.position).norm();
    const double share = apart / (radii[a.index()] + radii[b.index()]);
    for (const CriticalId id : {a, b}) {
      result[id.index()] = std::min(result[id.index()], share * radii[id.index()]);
    }
  }
  return result;
}

}  // namespace morskin::morse
