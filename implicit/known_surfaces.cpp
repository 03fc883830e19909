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

/// The torus with its middle on the x axis.
std::string torus_at(double x, double R, double r) {
  const std::string off = "(x-" + number(x) + ")^2+y^2";
  const std::string A = "(" + off + "+z^2+" + number(R * R - r * r) + ")";
  return A + "/2-" + number(2 * R * R) + "*(" + off + ")/" + A;
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
  constexpr double R = 1, r = 0.4, apart = 1.2, decay = 3;
  const std::string minus = "exp(-" + number(decay) + "*(";
  return "-log(" + minus + torus_at(-apart, R, r) + "))+" + minus + torus_at(apart, R, r) + ")))/" +
         number(decay);
}

}  // namespace morskin::implicit
