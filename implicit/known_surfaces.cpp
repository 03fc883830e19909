#include "implicit/known_surfaces.h"

#include <cmath>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"

namespace morskin::implicit {

namespace {

/// With all digits, in parentheses; with a point in any locale, as Expression reads it.
std::string number(double x) {
  std::string text = "(";
  geometry::append_number(text, x);
  return text + ")";
}

}  // namespace

std::string sphere_formula(double radius) {
  if (!(radius > 0 && std::isfinite(radius * radius))) {
    throw geometry::RefusedInput("a sphere's radius must be above 0, and its square finite");
  }
  return "x^2+y^2+z^2-" + number(radius * radius);
}

std::string torus_formula(double R, double r) {
  if (!(r > 0 && R > r && std::isfinite(2 * R * R))) {
    throw geometry::RefusedInput("a torus R,r must have R > r > 0, and R^2 finite");
  }
  // With c = R^2 - r^2 (R s)^2 / A is R^2 less R^2 (z^2 + c) / A, where fewer variables stand
  // twice, so that intervals are narrower.
  const std::string c = number(R * R - r * r);
  const std::string A = "(x^2+y^2+z^2+" + c + ")";
  return A + "/2-" + number(2 * R * R) + "+" + number(2 * R * R) + "*(z^2+" + c + ")/" + A;
}

std::string genus2_formula() {
  return "((x^2+y^2)^2-8*(x^2-y^2))^2/(256*(x^2+y^2+0.25))+z^2-0.2025";
}

}  // namespace morskin::implicit
