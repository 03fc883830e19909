#include "geometry/exact_range.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace morskin::geometry {

namespace {

/// The multiple of a power of two that is nearest to x. Of 2^52 units and more x is one itself.
double nearest_multiple(double x, double unit) {
  return std::fabs(x) < 0x1p52 * unit ? std::round(x / unit) * unit : x;
}

bool is_exact(double x, double unit) {
  return std::fabs(x) <= largest_exact && nearest_multiple(x, unit) == x;
}

}  // namespace

double on_exact_grid(double x) { return nearest_multiple(x, coordinate_unit); }

bool is_exact_coordinate(double x) { return is_exact(x, coordinate_unit); }

bool is_exact_weight(double w) { return is_exact(w, weight_unit); }

std::size_t move_to_exact_grid(std::span<WeightedPoint> points) {
  constexpr double min_weight = 0x1p-136;
  const auto is_tiny = [](const WeightedPoint& p) { return std::fabs(p.weight) < min_weight; };
  if (std::ranges::any_of(points, is_tiny)) return 0;
  std::size_t moved = 0;
  for (WeightedPoint& p : points) {
    for (double& x : p.position) {
      const double rounded = on_exact_grid(x);
      if (rounded != x) ++moved;
      x = rounded;
    }
  }
  return moved;
}

}  // namespace morskin::geometry
