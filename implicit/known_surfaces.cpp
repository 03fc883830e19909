#include "implicit/known_surfaces.h"

#include <cmath>
#include <cstdio>

#include "geometry/error.h"

namespace morskin::implicit {

namespace {

/// With all digits, in parentheses.
std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "(%.17g)", x);
  return text;
}

/// The torus with its middle on the x axis. With c = R^2 - r^2 (R s)^2 / A is R^2 less
/// R^2 (z^2 + c) / A, where fewer variables stand twice, so that intervals are narrower.
std::string torus_at(double x, double R, double r) {
  const std::string c = number(R * R - r * r);
  const std::string A = "((x-" + number(x) + ")^2+y^2+z^2+" + c + ")";
  return A + "/2-" + number(2 * R * R) + "+" + number(2 * R * R) + "*(z^2+" + c + ")/" + A;
}

}  // namespace

std::string sphere_formula(double radius) {
  if (!(radius > 0 && std::isfinite(radius))) {
    throw geometry::RefusedInput("a sphere's radius must be above 0");
  }
  return "x^2+y^2+z^2-" + number(radius * radius);
}

std::string torus_formula(double R, double r) {
  if (!(r > 0 && R > r && std::isfinite(R))) {
    throw geometry::RefusedInput("a torus R,r must have R > r > 0");
  }
  return torus_at(0, R, r);
}

std::string genus_2_formula() {
  constexpr double R = 1, r = 0.5, apart = 1.3, k = 0.5;
  const auto weight = [&](double x) {
    return number(k) + "/(" + torus_at(x, R, r) + "+" + number(k) + ")";
  };
  return "1-" + weight(-apart) + "-" + weight(apart);
}

}  // namespace morskin::implicit
