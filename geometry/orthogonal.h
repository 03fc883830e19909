#pragma once

#include <Eigen/Geometry>
#include <cmath>

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

/// Two unit vectors across a unit normal, right-handed: first x second = normal.
struct TangentFrame {
  Vector first, second;

  explicit TangentFrame(const Vector& normal) {
    // The axis that is farthest from the normal, made orthogonal to it.
    Eigen::Index least = 0;
    normal.cwiseAbs().minCoeff(&least);
    first = (Vector::Unit(least) - normal[least] * normal).normalized();
    second = normal.cross(first);
  }
  /// The unit vector at an angle from the first, towards the second, radians.
  Vector direction(double angle) const {
    return std::cos(angle) * first + std::sin(angle) * second;
  }
};

}  // namespace morskin::geometry
