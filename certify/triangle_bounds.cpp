#include "certify/triangle_bounds.h"

#include <array>
#include <limits>
#include <utility>

namespace morskin::certify {

TriangleBounds triangle_bounds(const Point& a, const Point& b, const Point& c) {
  constexpr double cross_rounding = 0x1p-50;
  constexpr double rest = 1 + 0x1p-40;        // of the few operations behind the cross product
  constexpr double smallest_area = 0x1p-300;  // squared areas are far above subnormal numbers
  // Edge k joins corners k and k + 1. From the corner opposite the longest start the other two.
  std::array<Vector, 3> edge{b - a, c - b, a - c};
  std::array<double, 3> length{edge[0].norm(), edge[1].norm(), edge[2].norm()};
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (length[k] > length[longest]) longest = k;
  }
  const std::size_t e = (longest + 1) % 3, f = (longest + 2) % 3;
  const Vector cross = edge[e].cross(edge[f]);
  const double doubled_area = cross.norm();
  const double error = cross_rounding * length[e] * length[f];
  const double least = doubled_area - error;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(least > smallest_area)) return {infinity, Vector::Zero(), infinity};
  return {rest * length[0] * length[1] * length[2] / (2 * least), cross / doubled_area,
          rest * 2 * error / least};
}

}  // namespace morskin::certify
