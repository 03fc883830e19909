#include "morse/protecting_spheres.h"

#include <algorithm>
#include <cmath>

#include "geometry/kd_tree.h"

namespace morskin::morse {

ProtectingSpheres::ProtectingSpheres(std::span<const CriticalPoint> points,
                                     std::vector<double> radii, std::vector<Incidence> incidences,
                                     std::size_t cells)
    : radius_(std::move(radii)) {
  for (const CriticalPoint& p : points) centres_.push_back(p.point.position);
  std::sort(incidences.begin(), incidences.end());
  spheres_ = geometry::grouped<CriticalId>(cells, [&](auto visit) {
    for (const auto& [cell, id] : incidences) visit(cell.index(), id);
  });
}

std::optional<CriticalId> ProtectingSpheres::containing(const surface::SurfacePoint& p) const {
  if (p.cell.index() >= spheres_.group_count()) return std::nullopt;  // on a wall, up to rounding
  for (const CriticalId id : spheres_.of(p.cell.index())) {
    const double r = radius_[id.index()];
    if ((centres_[id.index()] - p.position).squaredNorm() < r * r) return id;
  }
  return std::nullopt;
}

std::vector<double> disjoint_radii(std::span<const CriticalPoint> points, double radius_share) {
  std::vector<Point> positions;
  positions.reserve(points.size());
  for (const CriticalPoint& p : points) positions.push_back(p.point.position);
  const geometry::KdTree<CriticalId> tree(positions);
  std::vector<double> radii;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double full = radius_share * points[i].point.length_scale;
    // A little beyond twice the full radius, so that only the minimum below decides.
    const auto other =
        tree.nearest(positions[i], 2.01 * full, [&](CriticalId j) { return j.index() != i; });
    radii.push_back(other ? std::min(full, std::sqrt(other->squared_distance) / 2) : full);
  }
  return radii;
}

}  // namespace morskin::morse
