// Formulas: what they are worth, that their bounds hold, and what is refused with its column.

#include "implicit/expression.h"

#include <array>
#include <functional>
#include <string>

#include "geometry/error.h"
#include "implicit/implicit_surface.h"
#include "tests/support/test.h"

using namespace morskin;
using implicit::Box;
using implicit::Expression;

namespace {

double value(const char* text, const geometry::Point& x) { return Expression(text).at(x).value; }

std::string refusal(const std::string& text) {
  try {
    Expression parsed(text);
  } catch (const geometry::UnreadableInput& error) {
    return error.what();
  }
  return "";
}

/// A formula in which each $ is another.
std::string filled(const char* form, const std::function<std::string()>& part) {
  std::string text;
  for (; *form != 0; ++form) *form == '$' ? text.append(part()) : text.append(1, *form);
  return text;
}

/// A random formula whose functions are defined everywhere.
std::string some_formula(support::Random& random, int depth) {
  constexpr std::array leaves{"x", "y", "z", "1.5", "0.25"};
  constexpr std::array forms{"($+$)",  "($-$)",  "$*$",         "($)/(1+($)^2)", "sqrt(1+($)^2)",
                             "sin($)", "cos($)", "exp(-($)^2)", "log(2+($)^2)"};
  if (depth == 0) return leaves[random.below(leaves.size())];
  return filled(forms[random.below(forms.size())], [&] { return some_formula(random, depth - 1); });
}

}  // namespace

TEST_CASE("operators bind as in mathematics") {
  const geometry::Point p(2, 3, 5);
  CHECK(value("x+y*z", p) == 17);
  CHECK(value("-x^2", p) == -4);
  CHECK(value("(-x)^2", p) == 4);
  CHECK(value("z-y-x", p) == 0);
  CHECK(value("12/x/y", p) == 2);
  CHECK(value("x^2^3", p) == 256);
  CHECK(value("(x^2)^3", p) == 64);
  CHECK(value("x^2^1^5", p) == 4);
  CHECK(value("2*-x", p) == -4);
  CHECK(value(" 1.5e1 + .5*x ", p) == 16);
  CHECK(value("sqrt(x+2)*exp(0)-log(1)+sin(0)+cos(0)", p) == 3);
  CHECK(value("x^0", p) == 1);
}

TEST_CASE("bounds of formulas over a box hold at points of the box") {
  support::for_seeds(400, [&](unsigned seed) {
    support::Random random(seed);
    const std::string text = some_formula(random, 3);
    CAPTURE(text);
    const Expression f(text);
    const Box box{geometry::Point(random.uniform(), random.uniform(), random.uniform()) * 2,
                  std::exp2(-8 * random.uniform())};
    const auto natural = f.over(box), sharp = f.bounds(box);
    CHECK(sharp.value.width() <= natural.value.width());
    for (int k = 0; k < 10; ++k) {
      geometry::Point x = box.centre;
      for (int i = 0; i < 3; ++i) x[i] += box.half * (2 * random.uniform() - 1);
      const auto [value, gradient] = f.at(x);
      const auto near = f.enclose(x);
      // Rounding may lead a value itself out of bounds that are as narrow.
      const auto holds = [](const implicit::Interval& a, double v) {
        const double doubt = 1e-12 * (1 + std::abs(v));
        return a.low - doubt <= v && v <= a.high + doubt;
      };
      CHECK(holds(natural.value, value));
      CHECK(holds(sharp.value, value));
      CHECK(holds(near.value, value));
      CHECK(near.value.width() <= 1e-11 * (1 + std::abs(value)));
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(holds(sharp.gradient[i], gradient[static_cast<int>(i)]));
        CHECK(holds(near.gradient[i], gradient[static_cast<int>(i)]));
      }
      // Second derivatives, by those of the formula at the point.
      const auto there = f.over({x, 0});
      for (std::size_t i = 0; i < 6; ++i) {
        CHECK(there.hessian[i].low <= natural.hessian[i].high);
        CHECK(there.hessian[i].high >= natural.hessian[i].low);
      }
    }
  });
}

TEST_CASE("bad formulas are refused with the column") {
  CHECK(refusal("") == "formula, column 1: something is missing at the end");
  CHECK(refusal("x^2+") == "formula, column 5: something is missing at the end");
  CHECK(support::contains(refusal("x^2+w"), "column 5: w: neither"));
  CHECK(support::contains(refusal("x**2"), "column 3"));
  CHECK(support::contains(refusal("(x+1"), "column 5: \")\" is missing"));
  CHECK(support::contains(refusal("x 1"), "column 3: an operator is missing"));
  CHECK(support::contains(refusal("sin x"), "column 5: \"(\" is missing after sin"));
  CHECK(support::contains(refusal("x^-1"), "an exponent is a whole number"));
  CHECK(support::contains(refusal("x^0.5"), "an exponent is a whole number"));
  CHECK(support::contains(refusal("x^2^7"), "column 3: an exponent is a whole number"));
  CHECK(support::contains(refusal("x^65"), "an exponent is a whole number"));
  CHECK(support::contains(refusal("x^y"), "an exponent is a whole number"));
  CHECK(support::contains(refusal("1e999*x"), "no number that a double holds"));
  CHECK(support::contains(refusal(std::string(1000, '(')), "nested too deeply"));
  CHECK(support::contains(refusal(std::string(1000, '-') + "x"), "nested too deeply"));
  CHECK(support::contains(refusal(std::string(20000, 'x')), "longer than"));
  CHECK(refusal(std::string("x\0y", 3)) != "");
}

TEST_CASE("a formula as long and as deep as is allowed is worth what it should") {
  std::string text = "x";
  while (text.size() + 2 < Expression::max_length) text += "+x";
  CHECK(value(text.c_str(), {1, 0, 0}) == static_cast<double>((text.size() + 1) / 2));
  std::string nested = "x";
  for (std::size_t i = 0; i + 2 < Expression::max_depth; ++i) nested = "(y+" + nested + ")";
  CHECK(refusal(nested) != "");  // each level takes two: a sum and a bracket
  std::string shallower = "x";
  for (std::size_t i = 0; 2 * i + 3 < Expression::max_depth; ++i) {
    shallower = "(y+" + shallower + ")";
  }
  CHECK(value(shallower.c_str(), {1, 1, 0}) == (Expression::max_depth - 3 + 1) / 2 + 1);
}

TEST_CASE("a formula so steep that its bounds do not tell its zeros is not called singular") {
  const Expression steep("exp(1000*(x^2+y^2+z^2-1))-1");
  std::string why;
  try {
    implicit::cover(steep, {geometry::Point::Zero(), 2}, {}, geometry::Run());
  } catch (const geometry::RefusedInput& error) {
    why = error.what();
  }
  CHECK(support::contains(why, "too wide to tell its zeros"));
}

TEST_CASE("a formula so small that its bounds tell nothing is not only called open") {
  const auto flat = std::make_shared<Expression>("1e-160*(x^2+y^2+z^2-1)");
  std::string why;
  try {
    implicit::prepare_surface(flat, {{geometry::Point::Zero(), 2}, true}, {});
  } catch (const geometry::RefusedInput& error) {
    why = error.what();
  }
  CHECK(support::contains(why, "too wide to tell"));
}
