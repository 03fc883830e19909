#include "morse/skin_spheres.h"

#include <algorithm>
#include <utility>

namespace morskin::morse {

namespace {

using skin::CellId;

/// Finds the cells that balls meet. A cell may have as many walls as there are atoms, so each is
/// looked at once for each ball.
class CellSearch {
 public:
  explicit CellSearch(const skin::MixedComplex& complex)
      : complex_(complex), is_seen_(complex.size(), false) {}

  /// Those of a ball about a point of `start`, by crossing the walls it cuts.
  std::vector<CellId> cells_within(const Point& centre, CellId start, double radius) {
    const double far = radius + complex_.wall_tolerance();
    std::vector<CellId> reached{start}, seen{start};
    is_seen_[start.index()] = true;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const skin::Wall& wall : complex_.walls(reached[i])) {
        if (wall.offset - wall.normal.dot(centre) > far || is_seen_[wall.beyond.index()]) continue;
        is_seen_[wall.beyond.index()] = true;
        seen.push_back(wall.beyond);
        if (is_met(wall.beyond, centre, far)) reached.push_back(wall.beyond);
      }
    }
    for (const CellId cell : seen) is_seen_[cell.index()] = false;
    return reached;
  }

 private:
  /// The ball meets the cell unless one of its walls separates them.
  bool is_met(CellId cell, const Point& centre, double far) const {
    const skin::Walls walls = complex_.walls(cell);
    return std::ranges::all_of(walls, [&](const skin::Wall& wall) {
      return wall.normal.dot(centre) - wall.offset <= far;
    });
  }

  const skin::MixedComplex& complex_;
  std::vector<bool> is_seen_;  ///< by cell
};

}  // namespace

ProtectingSpheres protecting_spheres(const skin::SkinSurface& skin,
                                     std::span<const CriticalPoint> points, double radius_share) {
  return protecting_spheres(skin, points, disjoint_radii(points, radius_share));
}

ProtectingSpheres protecting_spheres(const skin::SkinSurface& skin,
                                     std::span<const CriticalPoint> points,
                                     std::vector<double> radii) {
  std::vector<ProtectingSpheres::Incidence> incidences;
  CellSearch search(skin.complex());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const surface::SurfacePoint& p = points[i].point;
    for (const CellId cell : search.cells_within(p.position, p.cell, radii[i])) {
      if (skin.complex().is_kept(cell)) incidences.emplace_back(cell, CriticalId{i});
    }
  }
  return {points, std::move(radii), std::move(incidences), skin.cell_count()};
}

}  // namespace morskin::morse
