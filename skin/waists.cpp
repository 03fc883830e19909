#include "skin/waists.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace morskin::skin {

namespace {

/// Whether a wall lies across an axis; the others lie along it.
bool is_across(const Wall& wall, const Vector& axis) {
  constexpr double parallel = 0.999;
  return std::abs(wall.normal.dot(axis)) >= parallel;
}

/// How far a cell goes from its orthocentre along an axis, Angstrom; `farthest` where no wall ends
/// it.
double reach(const SkinSurface& skin, CellId cell, const Patch& patch, const Vector& axis,
             double farthest) {
  double distance = farthest;
  for (const Wall& wall : skin.complex().kept_walls(cell)) {
    if (!is_across(wall, axis) || wall.normal.dot(axis) < 0) continue;
    distance = std::min(distance, wall.offset - wall.normal.dot(patch.centre));
  }
  return std::max(distance, 0.0);
}

/// Whether a point is within all walls of a cell, less a margin.
bool is_within(const SkinSurface& skin, const Point& x, CellId cell, double margin) {
  return std::ranges::all_of(skin.complex().kept_walls(cell), [&](const Wall& wall) {
    return wall.normal.dot(x) - wall.offset < -margin;
  });
}

/// Points of the circle in the cell, in which its centre lies: the ends of its arcs there, where
/// walls along the axis cut it, or any one of a whole circle. Of a narrow cell deep in the body
/// there are none, and then no piece of the skin.
std::vector<Point> circle_points(const SkinSurface& skin, CellId cell, const Patch& patch,
                                 double radius) {
  const double tolerance = skin.complex().wall_tolerance();
  std::vector<Point> found;
  bool is_cut = false;
  for (const Wall& wall : skin.complex().kept_walls(cell)) {
    const double to_wall = wall.offset - wall.normal.dot(patch.centre);
    if (is_across(wall, patch.axis) || to_wall >= radius) continue;
    is_cut = true;
    const Point middle = patch.centre + to_wall * wall.normal;
    const double half = std::sqrt((radius - to_wall) * (radius + to_wall));
    for (const double side : {-half, half}) {
      const Point end = middle + side * patch.axis.cross(wall.normal);
      if (is_within(skin, end, cell, -tolerance)) found.push_back(end);
    }
  }
  if (!is_cut) found.push_back(patch.centre + radius * patch.axis.unitOrthogonal());
  return found;
}

/// How far a cell goes from its axis in a direction across, Angstrom.
double reach_across(const SkinSurface& skin, CellId cell, const Patch& patch,
                    const Vector& direction) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Wall& wall : skin.complex().kept_walls(cell)) {
    const double cosine = wall.normal.dot(direction);
    if (is_across(wall, patch.axis) || cosine <= 0) continue;
    distance = std::min(distance, (wall.offset - wall.normal.dot(patch.centre)) / cosine);
  }
  return distance;
}

/// At a distance s from the circle's plane the hyperboloid has rho^2 = c^2 + 2 s^2, and a ring of
/// it the area 2 pi rho ds. In each direction across the axis it leaves the cell where its distance
/// from the axis, sqrt(c^2 + s^2), is that of the walls there.
double demand(const SkinSurface& skin, CellId cell, const Patch& patch, double radius, double below,
              double above) {
  constexpr int directions = 32;
  const Vector u = patch.axis.unitOrthogonal(), v = patch.axis.cross(u);
  const auto to = [&](double s) { return std::asinh(M_SQRT2 * s / radius); };
  double sum = 0;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * M_PI * i / directions;
    const double to_wall =
        reach_across(skin, cell, patch, std::cos(angle) * u + std::sin(angle) * v);
    if (to_wall <= radius) continue;
    const double end = std::sqrt((to_wall - radius) * (to_wall + radius));
    sum += to(std::min(below, end)) + to(std::min(above, end));
  }
  return M_PI * M_SQRT2 * sum / directions;
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
    // A cell without width, of cospherical atoms such as those of a square's diagonal, has its
    // orthocentre on walls and no piece of the skin.
    if (!is_within(skin, patch.centre, cell, skin.complex().wall_tolerance())) continue;
    const double radius = std::sqrt(std::abs(patch.half_weight));
    std::vector<Point> on_skin = circle_points(skin, cell, patch, radius);
    if (on_skin.empty()) continue;
    const double below = reach(skin, cell, patch, -patch.axis, farthest);
    const double above = reach(skin, cell, patch, patch.axis, farthest);
    found.push_back({cell, is_tunnel, patch.centre, radius,
                     demand(skin, cell, patch, radius, below, above), std::move(on_skin)});
  }
  std::ranges::sort(found, {}, [](const Waist& w) { return std::pair(w.radius, w.cell.value); });
  return found;
}

}  // namespace morskin::skin
