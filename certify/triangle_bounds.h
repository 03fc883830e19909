#pragma once

#include "certify/triangle_geometry.h"

namespace morskin::certify {

/// Bounds on a triangle's shape, all rounding counted.
struct TriangleBounds {
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
/// @param shortest_edge  known to 2^-49 of itself, Angstrom
inline double smallest_sine(const TriangleBounds& triangle, double shortest_edge) {
  constexpr double down = 1 - 0x1p-48;
  return down * shortest_edge / (2 * triangle.circumradius);
}

}  // namespace morskin::certify
