#pragma once

#include <array>

#include "certify/triangle_geometry.h"

namespace morskin::certify {

/// The sides of a triangle: side k leads from corner k to the next.
struct TriangleSides {
  TriangleSides(const Point& a, const Point& b, const Point& c)
      : side{b - a, c - b, a - c},
        squared{side[0].squaredNorm(), side[1].squaredNorm(), side[2].squaredNorm()} {}
  explicit TriangleSides(const Corners& p)
      : TriangleSides(p[0]->position, p[1]->position, p[2]->position) {}

  double shortest() const { return std::sqrt(std::min({squared[0], squared[1], squared[2]})); }
  /// (2 R |n|)^2 for a normal n twice the triangle's area long.
  double squared_product() const { return squared[0] * squared[1] * squared[2]; }
  /// The corner opposite the longest.
  std::size_t top() const {
    std::size_t k = squared[2] > squared[1] ? 1 : 0;
    return squared[0] > squared[(k + 1) % 3] ? 2 : k;
  }

  std::array<Vector, 3> side;
  std::array<double, 3> squared;  ///< lengths, Angstrom^2
};

/// Bounds on a triangle's shape, all rounding counted.
struct TriangleBounds {
  TriangleSides sides;
  double circumradius;  ///< at least the true one, Angstrom; infinite where rounding hides it
  Vector normal;        ///< unit
  double normal_error;  ///< bound on the distance to the true unit normal
};

/// The cross product of two edges from one corner is off by 8 u |e| |f| at most, u = 2^-53: each
/// difference of coordinates is rounded once, so a component e_y f_z - e_z f_y is off by 4 u (|e_y
/// f_z| + |e_z f_y|), and these sums make a vector no longer than sqrt(2) |e| |f|.
/// The two shorter edges are taken, so needles lose the least.
TriangleBounds triangle_bounds(const Point& a, const Point& b, const Point& c);

/// Lower bound on the sine of a triangle's smallest angle: its shortest edge over the diameter of
/// its circumcircle.
inline double smallest_sine(const TriangleBounds& triangle) {
  constexpr double down = 1 - 0x1p-48;
  return down * triangle.sides.shortest() / (2 * triangle.circumradius);
}

}  // namespace morskin::certify
