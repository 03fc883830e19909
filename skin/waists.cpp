#include "skin/waists.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace morskin::skin {

namespace {

/// How far a cell goes from its orthocentre along an axis, Angstrom; `farthest` where no wall ends
/// it.
double reach(const SkinSurface& skin, CellId cell, const Patch& patch, const Vector& axis,
             double farthest) {
  constexpr double parallel = 0.999;  // walls across the axis; the others lie along it
  double distance = farthest;
  for (const Wall& wall : skin.complex().kept_walls(cell)) {
    if (wall.normal.dot(axis) < parallel) continue;
    distance = std::min(distance, wall.offset - wall.normal.dot(patch.centre));
  }
  return std::max(distance, 0.0);
}

/// Whether a point lies in a cell and on no wall of it. A cell without width, of cospherical atoms
/// such as those of a square's diagonal, has its orthocentre on walls and no piece of the skin.
bool is_inside(const SkinSurface& skin, const Point& x, CellId cell) {
  return std::ranges::all_of(skin.complex().kept_walls(cell), [&](const Wall& wall) {
    return wall.normal.dot(x) - wall.offset < -skin.complex().wall_tolerance();
  });
}

/// At a distance s from the circle's plane the hyperboloid has rho^2 = c^2 + 2 s^2, and a ring of
/// it the area 2 pi rho ds.
double demand(double radius, double below, double above) {
  const auto to = [&](double s) { return std::asinh(M_SQRT2 * s / radius); };
  return M_PI * M_SQRT2 * (to(below) + to(above));
}

}  // namespace

std::vector<Waist> waists(const SkinSurface& skin) {
  std::vector<Waist> found;
  const double farthest = 2 * skin.bounding_ball().radius;
  for (std::size_t i = 0; i < skin.cell_count(); ++i) {
    const CellId cell(i);
    const int dimension = skin.complex().dimension(cell);
    if (dimension != 1 && dimension != 2) continue;
    const Patch& patch = skin.complex().kept_patch(cell);
    const bool is_tunnel = dimension == 2;
    if (is_tunnel ? patch.half_weight >= 0 : patch.half_weight <= 0) continue;
    if (!is_inside(skin, patch.centre, cell)) continue;
    const double radius = std::sqrt(std::abs(patch.half_weight));
    const double below = reach(skin, cell, patch, -patch.axis, farthest);
    const double above = reach(skin, cell, patch, patch.axis, farthest);
    found.push_back({cell, is_tunnel, patch.centre, radius, demand(radius, below, above)});
  }
  std::ranges::sort(found, {}, [](const Waist& w) { return std::pair(w.radius, w.cell.value); });
  return found;
}

}  // namespace morskin::skin
