#include "geometry/exact_range.h"

#include <span>

#include "geometry/orthosphere.h"
#include "geometry/predicates_internal.h"
#include "skin/orthocentre.h"
#include "tests/support/big_integer.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using support::BigInteger;

namespace {

using Balls = std::vector<WeightedPoint>;

/// Where a set of numbers lies in the range: at its lower end, at its upper end, or from end to
/// end.
enum class Where { Low, High, Mixed };
constexpr Where everywhere[] = {Where::Low, Where::High, Where::Mixed};

/// A multiple of the unit with up to 53 bits in use, at most 2^30; often a small one, for ties.
double number(std::mt19937_64& random, Where where, double unit) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const double digits = below(2) == 0 ? below(7) - 3 : std::ldexp(random() >> 11, -below(53));
  const double x = (below(2) == 0 ? -1 : 1) * std::floor(digits);
  const int lowest = std::ilogb(unit), highest = 30 - 53;
  const int exponent = where == Where::Low    ? lowest
                       : where == Where::High ? highest
                                              : lowest + below(highest - lowest + 1);
  return std::ldexp(x, exponent);
}

Balls some_balls(unsigned seed, Where where, std::size_t count) {
  std::mt19937_64 random(seed);
  Balls balls(count);
  for (WeightedPoint& ball : balls) {
    for (double& x : ball.position) x = number(random, where, coordinate_unit);
    ball.weight = number(random, where, weight_unit);
  }
  return balls;
}

BigInteger exact_coordinate(double x) { return {x, 120}; }
BigInteger exact_weight(double w) { return {w, 240}; }

std::array<BigInteger, 3> difference(const WeightedPoint& p, const WeightedPoint& q) {
  std::array<BigInteger, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    result[k] = exact_coordinate(p.position[axis]) - exact_coordinate(q.position[axis]);
  }
  return result;
}

BigInteger dot(const std::array<BigInteger, 3>& a, const std::array<BigInteger, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// |p - q|^2 + w_q - w_p
BigInteger power(const WeightedPoint& p, const WeightedPoint& q) {
  const auto d = difference(p, q);
  return dot(d, d) + exact_weight(q.weight) - exact_weight(p.weight);
}

/// Homogeneous coordinates: no differences.
Sign exact_orientation(const Balls& p) {
  std::array<std::array<BigInteger, 4>, 4> m;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      m[i][k] = exact_coordinate(p[i].position[static_cast<Eigen::Index>(k)]);
    }
    m[i][3] = BigInteger(1, 0);
  }
  return support::permuted_determinant(m).sign();
}

Sign exact_orthosphere(const Balls& p) {
  std::array<std::array<BigInteger, 5>, 5> m;
  for (std::size_t i = 0; i < 5; ++i) {
    std::array<BigInteger, 3> x;
    for (std::size_t k = 0; k < 3; ++k) {
      m[i][k] = x[k] = exact_coordinate(p[i].position[static_cast<Eigen::Index>(k)]);
    }
    m[i][3] = dot(x, x) - exact_weight(p[i].weight);
    m[i][4] = BigInteger(1, 0);
  }
  return support::permuted_determinant(m).sign();
}

/// The bordered Gram determinant of four points' three edges (geometry/orthosphere.cpp).
Sign exact_weight_sign(const Balls& p) {
  std::array<std::array<BigInteger, 4>, 4> m;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto e = difference(p[i + 1], p[0]);
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = dot(e, difference(p[j + 1], p[0]));
    m[i][3] = m[3][i] = power(p[i + 1], p[0]);
  }
  m[3][3] = exact_weight(4 * p[0].weight);
  return support::permuted_determinant(m).sign();
}

/// Of three points and a fourth.
Sign exact_power_sign(const Balls& p) {
  std::array<std::array<BigInteger, 3>, 3> m;
  const auto to_v = difference(p[3], p[0]);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto e = difference(p[i + 1], p[0]);
    for (std::size_t j = 0; j < 2; ++j) m[i][j] = dot(e, difference(p[j + 1], p[0]));
    m[i][2] = power(p[i + 1], p[0]);
    m[2][i] = dot(e, to_v);
  }
  m[2][2] = power(p[3], p[0]);
  return support::permuted_determinant(m).sign();
}

}  // namespace

TEST_CASE("what the predicates take loses nothing, and all ordinary numbers are among it") {
  for (const double x : {0.0, 0.1, -123.456, 0x1p30, 0x1p-120, 0x1.fffffffffffffp-68, 1e-17}) {
    CHECK(is_exact_coordinate(x));
    CHECK(on_exact_grid(x) == x);
  }
  for (const double x : {1e-300, 1e-25, 0x1.8p-120, 0x1.fffffffffffffp-69, -0x1p-80 - 0x1p-122}) {
    CHECK_FALSE(is_exact_coordinate(x));
    CHECK(std::abs(on_exact_grid(x) - x) <= 0x1p-121);
    CHECK(is_exact_coordinate(on_exact_grid(x)));
  }
  CHECK(is_exact_weight(0x1.fffffffffffffp-188));
  CHECK(is_exact_weight(0x1p-240));
  CHECK_FALSE(is_exact_weight(0x1.fffffffffffffp-189));
  CHECK_FALSE(is_exact_weight(0x1p-241));
  for (const double x : {std::nextafter(0x1p30, 0x1p31), std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_FALSE(is_exact_coordinate(x));
    CHECK_FALSE(is_exact_weight(-x));
  }
  Balls balls{{{0.1, 1e-25, 3}, 1}, {{0, -1e-300, 1e-25}, 1e-40}};
  CHECK(move_to_exact_grid(balls) == 3);
  CHECK(move_to_exact_grid(balls) == 0);
  CHECK(balls[1].position == Point(0, 0, on_exact_grid(1e-25)));
  Balls tiny{{{1e-25, 0, 0}, 1e-50}};
  CHECK(move_to_exact_grid(tiny) == 0);
  CHECK(tiny[0].position.x() == 1e-25);
}

TEST_CASE("every tier of the predicates is exact at both ends of the range and across it") {
  for (const Where where : everywhere) {
    support::for_seeds(400, [&](unsigned seed) {
      CAPTURE(static_cast<int>(where));
      const Balls p = some_balls(seed, where, 5);
      const Point &a = p[0].position, &b = p[1].position, &c = p[2].position, &d = p[3].position;
      const Sign volume = exact_orientation(p);
      CHECK(orientation(a, b, c, d) == volume);
      CHECK(internal::expanded_orientation(a, b, c, d) == volume);
      CHECK(internal::integer_orientation(a, b, c, d).value_or(volume) == volume);
      CHECK(internal::filtered_orientation(a, b, c, d).value_or(volume) == volume);
      const Sign power = exact_orthosphere(p);
      CHECK(internal::expanded_orthosphere(p[0], p[1], p[2], p[3], p[4]) == power);
      const auto filtered = internal::filtered_orthosphere(p[0], p[1], p[2], p[3], p[4]);
      CHECK(filtered.value_or(power) == power);
      const auto whole = internal::integer_orthosphere(p[0], p[1], p[2], p[3], p[4]);
      CHECK(whole.value_or(power) == power);
      const auto refined = internal::refined_orthosphere(p[0], p[1], p[2], p[3], p[4]);
      CHECK(refined.value_or(power) == power);
    });
  }
}

TEST_CASE("signs about orthospheres are exact at both ends of the range and across it") {
  for (const Where where : everywhere) {
    support::for_seeds(400, [&](unsigned seed) {
      CAPTURE(static_cast<int>(where));
      const Balls p = some_balls(seed, where, 4);
      if (exact_orientation(p) == Sign::Zero) return;
      CHECK(orthosphere_weight_sign(p) == exact_weight_sign(p));
      CHECK(orthosphere_power_sign(std::span(p).first(3), p[3]) == exact_power_sign(p));
    });
  }
}

TEST_CASE("an orthocentre scaled by a power of two is that of the scaled balls, to the last bit") {
  support::for_seeds(2000, [&](unsigned seed) {
    support::Random random(seed);
    const auto small = [&] { return random.whole(-9, 9); };
    const auto many = [&] { return random.whole(-(1 << 20), 1 << 20); };
    Balls large(2 + seed % 3);
    for (WeightedPoint& ball : large) {
      for (double& x : ball.position) x = seed % 2 == 0 ? small() : many();
      ball.weight = 1 + std::abs(many());
    }
    if (seed % 4 == 0) large.back().position.x() += 0x1p-30;  // flat but for that
    if (large.size() == 2 && large[0].position == large[1].position) return;
    if (large.size() == 3 &&
        are_collinear(large[0].position, large[1].position, large[2].position)) {
      return;
    }
    if (large.size() == 4 && exact_orientation(large) == Sign::Zero) return;
    Balls tiny = large;
    for (WeightedPoint& ball : tiny) {
      ball.position *= 0x1p-90;
      ball.weight *= 0x1p-180;
    }
    const skin::Orthocentre z = skin::orthocentre(large), scaled = skin::orthocentre(tiny);
    CHECK(scaled.position == z.position * 0x1p-90L);
    CHECK(scaled.weight == z.weight * 0x1p-180L);
    CHECK(scaled.normal == z.normal);
  });
}

TEST_CASE("five points whose weights dwarf their distances are told apart as exactly as others") {
  // w = |x|^2 + K a . x + c is a tie for any K, and one last digit breaks it.
  std::size_t ties = 0;
  support::for_seeds(3000, [&](unsigned seed) {
    support::Random random(seed);
    const auto whole = [&](double most) { return std::floor(random.between(-most, most)); };
    const double K = std::ldexp(1, static_cast<int>(random.below(30)));
    const Point a(whole(9), whole(9), whole(9));
    Balls balls;
    for (int i = 0; i < 5; ++i) {
      const Point x(whole(1000), whole(1000), whole(1000));
      balls.push_back({x, x.squaredNorm() + K * a.dot(x)});
    }
    const double by = std::ldexp(1, -static_cast<int>(random.below(12)));
    if (random.below(3) != 0) balls[random.below(5)].weight += random.below(2) == 0 ? by : -by;
    if (random.below(4) == 0) balls[random.below(5)].weight += whole(1000 * K);
    const auto& [p, q, r, s, e] = std::array{balls[0], balls[1], balls[2], balls[3], balls[4]};
    const Sign exact = internal::expanded_orthosphere(p, q, r, s, e);
    ties += exact == Sign::Zero;
    for (const auto& sign : {internal::filtered_orthosphere(p, q, r, s, e),
                             internal::refined_orthosphere(p, q, r, s, e),
                             internal::integer_orthosphere(p, q, r, s, e)}) {
      if (sign) CHECK(*sign == exact);
    }
  });
  CHECK(ties > 500);
}

TEST_CASE("a last digit that only one of two numbers has breaks a tie") {
  // The corners of a cube about 0 have the distance sqrt 3 from it, e has sqrt 2 or 2.
  const Balls cube{{{1, 1, 1}, 0}, {{-1, -1, 1}, 0}, {{-1, 1, -1}, 0}, {{1, -1, -1}, 0}};
  const auto side = [](const Balls& of, const WeightedPoint& e) {
    const auto [p, q, r, s] = std::array{of[0], of[1], of[2], of[3]};
    const Sign exact = internal::expanded_orthosphere(p, q, r, s, e);
    CHECK(internal::integer_orthosphere(p, q, r, s, e).value_or(exact) == exact);
    return exact;
  };
  for (const double little : {0x1p-60, 0x1p-50, 0x1p-44}) {
    for (const double sign : {-1.0, 1.0}) {
      Balls heavy = cube, one = cube;
      for (WeightedPoint& p : heavy) p.weight = 1;
      CHECK(side(heavy, {{1, 1, 0}, sign * little}) != Sign::Zero);
      one[2].weight = sign * little;
      CHECK(side(one, {{2, 0, 0}, 1}) != Sign::Zero);
    }
  }
  const double third = 1.0 / 3;
  for (const double y : {std::nextafter(third, 0), std::nextafter(third, 1)}) {
    const Point a(0, 0, 0), b(1, 1, 0), c(0, 0, 1), d(third, y, 0.5);
    CHECK(orientation(a, b, c, d) == internal::expanded_orientation(a, b, c, d));
    CHECK(orientation(d, b, c, a) == internal::expanded_orientation(d, b, c, a));
  }
}

TEST_CASE("points of a line are collinear though no difference of their coordinates is exact") {
  support::for_seeds(1000, [](unsigned seed) {
    support::Random random(seed);
    std::array<Point, 3> p;
    for (Point& at : p) {
      const int exponent = static_cast<int>(random.below(40)) - 71;
      const double x = std::ldexp(std::floor(random.uniform() * 0x1p51), exponent);
      at = Point(x, 3 * x, -x);
    }
    CHECK(are_collinear(p[0], p[1], p[2]));
    const double off = std::nextafter(p[1].z(), 1);
    if (p[0] != p[2]) CHECK_FALSE(are_collinear(p[0], Point(p[1].x(), p[1].y(), off), p[2]));
  });
}
