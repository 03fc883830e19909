#pragma once

#include <Eigen/Geometry>

#include "geometry/point.h"

namespace morskin::geometry {

/// The unit vector along the part of v orthogonal to n; where that is zero, any orthogonal to n.
///
/// Where v is nearly parallel to n, v - (n . v) n is mostly rounding and need not be orthogonal to
/// n. A second projection makes it so to the last bits.
/// @param n  unit
inline Vector unit_orthogonal_part(const Vector& v, const Vector& n) {
  const Vector once = v - n.dot(v) * n;
  const double length = once.norm();
  if (!(length > 0)) return n.unitOrthogonal();
  const Vector twice = once / length - n.dot(once / length) * n;
  const double left = twice.norm();
  return left > 0.5 ? Vector(twice / left) : n.unitOrthogonal();
}

}  // namespace morskin::geometry
