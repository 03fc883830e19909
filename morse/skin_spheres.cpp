#include "morse/skin_spheres.h"

#include <algorithm>
#include <utility>

namespace morskin::morse {

namespace {

using skin::CellId;

/// Cells that meet a ball about a point of `start`, found by crossing the walls it cuts.
std::vector<CellId> cells_within(const skin::MixedComplex& complex, const Point& centre,
                                 CellId start, double radius) {
  std::vector<CellId> reached{start};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const skin::Wall& wall : complex.walls(reached[i])) {
      if (wall.offset - wall.normal.dot(centre) > radius + complex.wall_tolerance()) continue;
      if (std::find(reached.begin(), reached.end(), wall.beyond) == reached.end()) {
        bool cut = true;  // the ball meets the cell beyond unless one of its walls separates them
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

ProtectingSpheres protecting_spheres(const skin::SkinSurface& skin,
                                     std::span<const CriticalPoint> points, double radius_share) {
  return protecting_spheres(skin, points, disjoint_radii(points, radius_share));
}

ProtectingSpheres protecting_spheres(const skin::SkinSurface& skin,
                                     std::span<const CriticalPoint> points,
                                     std::vector<double> radii) {
  std::vector<ProtectingSpheres::Incidence> incidences;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const surface::SurfacePoint& p = points[i].point;
    for (const CellId cell : cells_within(skin.complex(), p.position, p.cell, radii[i])) {
      if (skin.complex().is_kept(cell)) incidences.emplace_back(cell, CriticalId{i});
    }
  }
  return {points, std::move(radii), std::move(incidences), skin.cell_count()};
}

}  // namespace morskin::morse
