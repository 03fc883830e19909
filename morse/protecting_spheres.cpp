#include "morse/protecting_spheres.h"

#include <algorithm>
#include <numeric>

namespace morskin::morse {

namespace {

using skin::CellId;

/// Distance to the nearest other point, found along a sorted axis, or nothing within `reach`.
double nearest_distance(std::span<const CriticalPoint> points,
                        const std::vector<std::uint32_t>& by_height, std::size_t place,
                        double reach) {
  const CriticalPoint& p = points[by_height[place]];
  double nearest = reach;
  const auto look = [&](std::size_t q) {
    const CriticalPoint& other = points[by_height[q]];
    if (std::abs(other.value - p.value) > nearest) return false;
    nearest = std::min(nearest, (other.point.position - p.point.position).norm());
    return true;
  };
  for (std::size_t q = place + 1; q < by_height.size() && look(q); ++q) {
  }
  for (std::size_t q = place; q-- > 0 && look(q);) {
  }
  return nearest;
}

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

}  // namespace

ProtectingSpheres::ProtectingSpheres(const skin::SkinSurface& surface,
                                     std::span<const CriticalPoint> points, double radius_share)
    : points_(points), radius_(points.size()) {
  std::vector<std::uint32_t> by_height(points.size());
  std::iota(by_height.begin(), by_height.end(), 0U);
  std::sort(by_height.begin(), by_height.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(points[a].value, a) < std::pair(points[b].value, b);
  });
  for (std::size_t i = 0; i < by_height.size(); ++i) {
    const double full = radius_share * points[by_height[i]].point.length_scale;
    radius_[by_height[i]] = std::min(full, nearest_distance(points, by_height, i, 2 * full) / 2);
  }
  std::vector<std::pair<CellId, CriticalId>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const skin::SurfacePoint& p = points[i].point;
    for (const CellId cell : cells_within(surface.complex(), p.position, p.cell, radius_[i])) {
      pairs.emplace_back(cell, CriticalId{i});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  first_.assign(surface.complex().size() + 1, 0);
  for (const auto& [cell, id] : pairs) {
    ++first_[cell.index() + 1];
    reaching_.push_back(id);
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::optional<CriticalId> ProtectingSpheres::containing(const skin::SurfacePoint& p) const {
  for (std::uint32_t i = first_[p.cell.index()]; i < first_[p.cell.index() + 1]; ++i) {
    const CriticalId id = reaching_[i];
    const double r = radius_[id.index()];
    if ((points_[id.index()].point.position - p.position).squaredNorm() < r * r) return id;
  }
  return std::nullopt;
}

}  // namespace morskin::morse
