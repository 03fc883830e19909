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

/// A surface of genus 2: a tube of radius r = 0.45 about the lemniscate u = 0 in the plane z = 0,
/// u = s^2 - 2 a^2 (x^2 - y^2), s = x^2 + y^2, a = 2. On the lemniscate |grad u| = 4 a^2 sqrt(s),
/// so
///
///     u^2 / (16 a^4 (s + 1/4)) + z^2 - r^2
///
/// is nearly the square of the distance from it, less r^2; 1/4 keeps it smooth where the lemniscate
/// crosses itself.
std::string genus2_formula();

}  // namespace morskin::implicit
