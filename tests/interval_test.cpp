// Intervals and jets: enclosures hold what they should, and derivatives are those of differences.

#include "implicit/interval.h"

#include <cmath>
#include <limits>

#include "implicit/hessian_bound.h"
#include "implicit/jet.h"
#include "tests/support/seeds.h"
#include "tests/support/test.h"

using namespace morskin;
using implicit::Interval;

namespace {

/// Ends near zero, large and small, and now and then equal.
Interval some_interval(support::Random& random) {
  const double size = std::exp2(40 * random.uniform() - 20);
  const double a = size * (2 * random.uniform() - 1), b = size * (2 * random.uniform() - 1);
  if (random.below(8) == 0) return {a, a};
  return {std::min(a, b), std::max(a, b)};
}
double some_point(const Interval& a, support::Random& random) {
  const double share =
      random.below(4) == 0 ? static_cast<double>(random.below(2)) : random.uniform();
  return std::min(a.high, std::max(a.low, a.low + share * (a.high - a.low)));
}
bool holds(const Interval& a, long double x) { return a.low <= x && x <= a.high; }

}  // namespace

TEST_CASE("intervals hold the results of all numbers in their operands") {
  support::for_seeds(3000, [&](unsigned seed) {
    support::Random random(seed);
    const Interval a = some_interval(random), b = some_interval(random);
    const long double x = some_point(a, random), y = some_point(b, random);
    CHECK(holds(a + b, x + y));
    CHECK(holds(a - b, x - y));
    CHECK(holds(a * b, x * y));
    if (y != 0) CHECK(holds(a / b, x / y));
    CHECK(holds(-a, -x));
    CHECK(holds(square(a), x * x));
    CHECK(square(a).low <= square(a).high);
    CHECK(holds(implicit::power(a, 5), x * x * x * x * x));
    CHECK(holds(cos(a), std::cos(x)));
    CHECK(holds(sin(a), std::sin(x)));
    if (x < 700) CHECK(holds(exp(a), std::exp(x)));
    if (x > 0) CHECK(holds(log(a), std::log(x)));
    if (x >= 0) CHECK(holds(sqrt(a), std::sqrt(x)));
  });
}

TEST_CASE("an operation without a value gives the whole line") {
  const Interval across{-1, 2};
  for (const Interval& whole : {Interval(1.0) / across, log(across), sqrt(across),
                                Interval(0.0) / Interval(0.0), Interval::whole() / across}) {
    CHECK(whole.low == -std::numeric_limits<double>::infinity());
    CHECK(whole.high == std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("what overflows is no wrong bound") {
  const Interval huge{1e300, 1.5e308};
  const Interval product = huge * huge;
  CHECK(product.low > 0);
  CHECK(product.low <= std::numeric_limits<double>::max());
  CHECK(product.high == std::numeric_limits<double>::infinity());
  CHECK((product - product).low == -std::numeric_limits<double>::infinity());
  CHECK(holds(Interval::whole() * Interval(0.0), 0));
  CHECK(exp(Interval{-1e6, 1e6}).low >= 0);
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(holds(Interval(least) * Interval(0.5), least * 0.5L));
  CHECK(holds(Interval(least) * Interval(least), 0));
}

TEST_CASE("the sine and the cosine reach their turning points") {
  CHECK(cos(Interval{-0.1, 0.2}).high == 1);
  CHECK(cos(Interval{3, 3.5}).low == -1);
  CHECK(sin(Interval{1, 2}).high == 1);
  CHECK(sin(Interval{-2, -1}).low == -1);
  CHECK(sin(Interval{0, 7}).low == -1);
  CHECK(sin(Interval{1, 1.2}).high < 0.94);
}

TEST_CASE("the bounds of a levelling's slope hold however steep it is") {
  support::for_seeds(3000, [](unsigned seed) {
    support::Random random(seed);
    const implicit::Levelling levelling{std::pow(10, random.between(-3, 3))};
    const double f = random.between(-0.1, 0.7) * 1000 / levelling.rate;
    const Interval slope = levelling.slope(Interval(f));
    const long double exact =
        f > 0 ? std::exp(-static_cast<long double>(levelling.rate) * f) : 1.0L;
    CHECK(slope.low <= exact);
    CHECK(slope.high >= exact);
    const Interval wide = levelling.slope(Interval{f - 1, f + 1});
    CHECK(wide.low <= slope.low);
    CHECK(wide.high >= slope.high);
  });
  const Interval all = implicit::Levelling{}.slope(Interval::whole());
  CHECK(all.low <= 0);
  CHECK(all.high == 1);
}

TEST_CASE("derivatives of jets are those of differences") {
  support::for_seeds(300, [&](unsigned seed) {
    support::Random random(seed);
    using Number = implicit::Jet<double, 2>;
    const auto f = [](const Number& x, const Number& y, const Number& z) {
      return exp(x * y) / (Number(2.0) + square(z)) + sin(x) * cos(y) -
             sqrt(Number(3.0) + x * x) * log(Number(4.0) + y) + implicit::power(z - x, 3);
    };
    const geometry::Point p(random.uniform(), random.uniform(), random.uniform());
    const auto at = [&](const geometry::Point& q) {
      return f(Number::variable(q.x(), 0), Number::variable(q.y(), 1), Number::variable(q.z(), 2));
    };
    const Number whole = at(p);
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < 3; ++i) {
      const geometry::Vector e = step * geometry::Vector::Unit(static_cast<int>(i));
      const Number above = at(p + e), below = at(p - e);
      CHECK(whole.gradient[i] ==
            doctest::Approx((above.value - below.value) / (2 * step)).epsilon(1e-6));
      for (std::size_t j = 0; j < 3; ++j) {
        CHECK(whole.hessian[implicit::symmetric_index[i][j]] ==
              doctest::Approx((above.gradient[j] - below.gradient[j]) / (2 * step)).epsilon(1e-6));
      }
    }
  });
}
