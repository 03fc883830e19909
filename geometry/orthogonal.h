#pragma once

#include <Eigen/Geometry>

#include "geometry/point.h"

namespace morskin::geometry {

/// The direction of v's part orthogonal to n; where v has none, any direction orthogonal to n.
///
/// Where v runs nearly along n its part v - (n . v) n is mostly rounding, which has a part along n
/// as large as any. Taken a second time it leaves a direction orthogonal to n to the last bits.
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
