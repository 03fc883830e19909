#include "geometry/exact_positions.h"

#include <algorithm>
#include <cmath>

namespace morskin::geometry {

namespace {

constexpr double largest_coordinate = 0x1p30;
constexpr double grid = 0x1p-300;
constexpr double certainly_on_grid = 0x1p-248;  // 52 bits above the grid

bool is_in_range(const Point& p) {
  return std::ranges::all_of(p, [](double x) {
    return std::fabs(x) <= largest_coordinate && (x == 0 || std::fabs(x) >= certainly_on_grid);
  });
}

double scaled(double x, int exponent) {
  const double y = std::ldexp(x, exponent);
  return std::fabs(y) >= certainly_on_grid ? y : std::nearbyint(y / grid) * grid;
}

}  // namespace

ExactPositions::ExactPositions(std::span<const Point> positions) : positions_(positions) {
  if (std::ranges::all_of(positions, is_in_range)) return;
  double largest = 0;
  for (const Point& p : positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest < 2^exponent
  scaled_.reserve(positions.size());
  for (const Point& p : positions) {
    scaled_.emplace_back(scaled(p.x(), 30 - exponent), scaled(p.y(), 30 - exponent),
                         scaled(p.z(), 30 - exponent));
  }
  positions_ = scaled_;
}

}  // namespace morskin::geometry
