#include "morse/protecting_spheres.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/kd_tree.h"

namespace morskin::morse {

namespace {

using skin::CellId;

/// Cells that a ball about a point of `start` reaches, found by crossing the walls it cuts.
std::vector<CellId> cells_within(const skin::MixedComplex& complex, const Point& centre,
                                 CellId start, double radius) {
  std::vector<CellId> reached{start};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const skin::Wall& wall : complex.walls(reached[i])) {
      if (wall.offset - wall.normal.dot(centre) > radius + complex.wall_tolerance()) continue;
      if (std::find(reached.begin(), reached.end(), wall.beyond) == reached.end()) {
        bool cut = true;  // the ball reaches the cell beyond unless one of its walls shuts it out
        for (const skin::Wall& other : complex.walls(wall.beyond)) {
          cut = cut && other.normal.dot(centre) - other.offset <= radius + complex.wall_tolerance();
        }
        if (cut) reached.push_back(wall.beyond);
      }
    }
  }
  return reached;
}

std::vector<double> disjoint_radii(std::span<const CriticalPoint> points, double radius_share) {
  std::vector<Point> places;
  places.reserve(points.size());
  for (const CriticalPoint& p : points) places.push_back(p.point.position);
  const geometry::KdTree<CriticalId> tree(places);
  std::vector<double> radii;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double full = radius_share * points[i].point.length_scale;
    // Farther than 2 full is of no matter; the look goes a little beyond, so that only the minimum
    // below decides.
    const auto other =
        tree.nearest(places[i], 2.01 * full, [&](CriticalId j) { return j.index() != i; });
    radii.push_back(other ? std::min(full, std::sqrt(other->squared_distance) / 2) : full);
  }
  return radii;
}

}  // namespace

ProtectingSpheres::ProtectingSpheres(const skin::SkinSurface& surface,
                                     std::span<const CriticalPoint> points, double radius_share)
    : ProtectingSpheres(surface, points, disjoint_radii(points, radius_share)) {}

ProtectingSpheres::ProtectingSpheres(const skin::SkinSurface& surface,
                                     std::span<const CriticalPoint> points,
                                     std::vector<double> radii)
    : radius_(std::move(radii)) {
  for (const CriticalPoint& p : points) centres_.push_back(p.point.position);
  std::vector<std::pair<CellId, CriticalId>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const skin::SurfacePoint& p = points[i].point;
    for (const CellId cell : cells_within(surface.complex(), p.position, p.cell, radius_[i])) {
      if (surface.complex().is_kept(cell)) pairs.emplace_back(cell, CriticalId{i});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  first_.assign(surface.complex().kept_size() + 1, 0);
  for (const auto& [cell, id] : pairs) {
    ++first_[cell.index() + 1];
    reaching_.push_back(id);
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::optional<CriticalId> ProtectingSpheres::containing(const skin::SurfacePoint& p) const {
  if (p.cell.index() + 1 >= first_.size()) return std::nullopt;  // on a wall, but for rounding
  for (std::uint32_t i = first_[p.cell.index()]; i < first_[p.cell.index() + 1]; ++i) {
    const CriticalId id = reaching_[i];
    const double r = radius_[id.index()];
    if ((centres_[id.index()] - p.position).squaredNorm() < r * r) return id;
  }
  return std::nullopt;
}

}  // namespace morskin::morse
