#include "certify/triangle_bounds.h"

#include <limits>

namespace morskin::certify {

TriangleBounds triangle_bounds(const Point& a, const Point& b, const Point& c) {
  constexpr double cross_rounding = 0x1p-50;
  constexpr double rest = 1 + 0x1p-40;        // of the few operations behind the cross product
  constexpr double smallest_area = 0x1p-300;  // squared areas are far above subnormal numbers
  const TriangleSides sides(a, b, c);
  const std::size_t k = sides.top(), before = (k + 2) % 3;
  const Vector cross = sides.side[before].cross(sides.side[k]);
  const double doubled_area = cross.norm();
  const double error = cross_rounding * std::sqrt(sides.squared[before] * sides.squared[k]);
  const double least = doubled_area - error;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(least > smallest_area)) return {sides, infinity, Vector::Zero(), infinity};
  return {sides, rest * std::sqrt(sides.squared_product()) / (2 * least), cross / doubled_area,
          rest * 2 * error / least};
}

}  // namespace morskin::certify
