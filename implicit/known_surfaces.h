#pragma once

/// Formulas of well known surfaces, for Expression.

#include <string>

namespace morskin::implicit {

/// A sphere about the origin. @throws geometry::RefusedInput  unless radius > 0
std::string sphere_formula(double radius);

/// A tube of radius r about the circle of radius R round the z axis. With A = |x|^2 + R^2 - r^2 and
/// s the distance from the axis the torus is A = 2 R s, and
///
///     A / 2 - 2 (R s)^2 / A
///
/// has the gradient of (s - R)^2 + z^2 - r^2 on it, but second derivatives everywhere.
/// @throws geometry::RefusedInput  unless R > r > 0
std::string torus_formula(double R, double r);

}  // namespace morskin::implicit
