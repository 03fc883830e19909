#include "geometry/predicates.h"

#include "geometry/predicates_internal.h"
#include "tests/support/test.h"

namespace morskin::geometry {
namespace {

static_assert(!std::is_convertible_v<AtomId, VertexId>);

__extension__ typedef __int128 Int128;

using Balls = std::array<WeightedPoint, 5>;
using support::Random;

/// A small whole number, so that ties are common and 128 bits suffice for an oracle.
WeightedPoint whole_ball(Random& random, int range) {
  const auto coordinate = [&] { return random.whole(-range, range); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {{x, y, z}, coordinate()};
}

WeightedPoint ball_in_box(Random& random, double side) {
  const Point place = random.in_cube(0, side);
  return {place, random.between(0, side)};
}

template <class Make>
Balls five(Make make) {
  return {make(), make(), make(), make(), make()};
}

/// Determinants by elimination without fractions (Bareiss), not by cofactors as in the library.
template <std::size_t Size>
Sign eliminated_sign(std::array<std::array<Int128, Size>, Size> m) {
  Int128 divisor = 1;
  bool is_odd = false;
  for (std::size_t k = 0; k < Size; ++k) {
    std::size_t pivot = k;
    while (pivot < Size && m[pivot][k] == 0) ++pivot;
    if (pivot == Size) return Sign::Zero;
    if (pivot != k) is_odd = !is_odd;
    std::swap(m[pivot], m[k]);
    for (std::size_t i = k + 1; i < Size; ++i) {
      for (std::size_t j = k + 1; j < Size; ++j) {
        m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) / divisor;
      }
    }
    divisor = m[k][k];
  }
  const Sign sign = sign_of(m[Size - 1][Size - 1]);
  return is_odd ? -sign : sign;
}

/// Homogeneous coordinates (x, y, z, 1), the last but one of five |x|^2 - w: the oracle takes no
/// differences.
template <std::size_t Size>
Sign oracle(const Balls& p) {
  std::array<std::array<Int128, Size>, Size> m;
  for (std::size_t i = 0; i < Size; ++i) {
    m[i][3] = static_cast<Int128>(p[i].position.squaredNorm() - p[i].weight);
    m[i][Size - 1] = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      m[i][k] = static_cast<Int128>(p[i].position[static_cast<Eigen::Index>(k)]);
    }
  }
  return eliminated_sign(m);
}
Sign oracle_orientation(const Balls& p) { return oracle<4>(p); }
Sign oracle_orthosphere(const Balls& p) { return oracle<5>(p); }

Sign orientation_of(const Balls& p) {
  return orientation(p[0].position, p[1].position, p[2].position, p[3].position);
}

constexpr std::array<AtomId, 5> in_order{AtomId(0u), AtomId(1u), AtomId(2u), AtomId(3u),
                                         AtomId(4u)};

Side side_of(const Balls& p, const std::array<AtomId, 5>& ids = in_order) {
  return orthosphere_side(p[0], p[1], p[2], p[3], p[4], ids);
}

/// Every tier of both predicates that answers gives these signs.
void check_tiers(const Balls& p, Sign volume, Sign power) {
  const WeightedPoint &a = p[0], &b = p[1], &c = p[2], &d = p[3], &e = p[4];
  const auto check = [](const auto& answers, Sign sign) {
    for (const std::optional<Sign>& answer : answers) CHECK(answer.value_or(sign) == sign);
  };
  const auto volumes = [&](auto tier) {
    return std::optional<Sign>(tier(a.position, b.position, c.position, d.position));
  };
  check(std::array{volumes(internal::filtered_orientation), volumes(internal::integer_orientation),
                   volumes(internal::expanded_orientation)},
        volume);
  const auto powers = [&](auto tier) { return std::optional<Sign>(tier(a, b, c, d, e)); };
  check(std::array{powers(internal::filtered_orthosphere), powers(internal::integer_orthosphere),
                   powers(internal::refined_orthosphere), powers(internal::expanded_orthosphere)},
        power);
}

/// Makes the first four positively oriented; false if they are coplanar.
bool orient_positively(Balls& p) {
  const Sign sign = orientation_of(p);
  if (sign == Sign::Negative) std::swap(p[0], p[1]);
  return sign != Sign::Zero;
}

}  // namespace

TEST_CASE("every tier that answers agrees with elimination over the integers") {
  support::for_seeds<Random>(3000, [&](unsigned seed, Random& random) {
    const int range = seed % 3 == 0 ? 2 : seed % 3 == 1 ? 30 : 4000;
    const Balls p = five([&] { return whole_ball(random, range); });
    const auto& [a, b, c, d, e] = p;
    CHECK(internal::integer_orientation(a.position, b.position, c.position, d.position));
    CHECK(internal::integer_orthosphere(a, b, c, d, e));
    check_tiers(p, oracle_orientation(p), oracle_orthosphere(p));
  });
}

TEST_CASE("the tiers agree one last bit away from a tie") {
  support::for_seeds<Random>(1000, [&](Random& random) {
    Balls p = five([&] { return whole_ball(random, 3); });
    for (WeightedPoint& q : p) q.position = (q.position * 0.1).eval();
    for (WeightedPoint& q : p) q.weight = 0.1 * q.weight;
    p[4].position.x() = std::nextafter(p[4].position.x(), 1);
    const auto& [a, b, c, d, e] = p;
    const Sign exact = internal::expanded_orthosphere(a, b, c, d, e);
    // The point moved among the first four as well.
    const Balls other{a, b, c, e, d};
    const Sign volume =
        internal::expanded_orientation(a.position, b.position, c.position, e.position);
    check_tiers(other, volume, -exact);
  });
}

TEST_CASE("the filters settle 99 percent of ordinary cases") {
  Random random(1);
  int settled_volumes = 0;
  int settled_powers = 0;
  constexpr int cases = 20000;
  for (int i = 0; i < cases; ++i) {
    const auto [a, b, c, d, e] = five([&] { return ball_in_box(random, 100); });
    settled_volumes +=
        internal::filtered_orientation(a.position, b.position, c.position, d.position) ? 1 : 0;
    settled_powers += internal::filtered_orthosphere(a, b, c, d, e) ? 1 : 0;
  }
  CHECK(settled_volumes >= 0.99 * cases);
  CHECK(settled_powers >= 0.99 * cases);
}

TEST_CASE("near ties that the filter leaves open are mostly settled by 106 bits") {
  // Points within rounding of one sphere.
  Random random(1);
  int open = 0;
  int settled = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [a, b, c, d, e] = five([&] { return WeightedPoint{50 * random.direction(), 0}; });
    if (internal::filtered_orthosphere(a, b, c, d, e)) continue;
    ++open;
    const auto sign = internal::refined_orthosphere(a, b, c, d, e);
    settled += sign ? 1 : 0;
    if (sign) CHECK(*sign == internal::expanded_orthosphere(a, b, c, d, e));
  }
  CHECK(open > 1000);
  CHECK(settled >= 0.99 * open);
}

TEST_CASE("each later tier is reached") {
  const auto corner = [](double x, double y, double z) { return WeightedPoint{{x, y, z}, 0}; };
  const Balls cube{corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1), corner(0, 0, 0),
                   corner(1, 1, 1)};
  CHECK_FALSE(internal::filtered_orthosphere(cube[0], cube[1], cube[2], cube[3], cube[4]));
  CHECK(internal::integer_orthosphere(cube[0], cube[1], cube[2], cube[3], cube[4]) == Sign::Zero);
  Balls tenths = cube;
  for (WeightedPoint& q : tenths) {
    q.position = (q.position * 0.1 + Point(0.1, 0.2, 0.7)).eval();
  }
  CHECK_FALSE(internal::integer_orthosphere(tenths[0], tenths[1], tenths[2], tenths[3], tenths[4]));
  // A tie of coordinates too long for the integers: only the expansions know.
  Balls long_ones = cube;
  for (WeightedPoint& q : long_ones) q.position = (q.position * (1 + 0x1p-40)).eval();
  const auto& [a, b, c, d, e] = long_ones;
  CHECK_FALSE(internal::filtered_orthosphere(a, b, c, d, e));
  CHECK_FALSE(internal::refined_orthosphere(a, b, c, d, e));
  CHECK(internal::expanded_orthosphere(a, b, c, d, e) == Sign::Zero);
  CHECK_FALSE(internal::integer_orientation(tenths[0].position, tenths[1].position,
                                            tenths[2].position, tenths[3].position));
}

TEST_CASE("exchanging two points changes the sign of the orientation") {
  support::for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    Balls p = five([&] { return whole_ball(random, seed % 2 == 0 ? 2 : 100); });
    const Sign sign = orientation_of(p);
    const std::size_t i = seed % 4;
    std::swap(p[i], p[(i + 1 + seed / 4 % 3) % 4]);
    CHECK(orientation_of(p) == -sign);
  });
}

TEST_CASE("an even permutation with its ids does not move a point across the orthosphere") {
  support::for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    Balls p = five([&] { return whole_ball(random, seed % 2 == 0 ? 1 : 100); });
    if (!orient_positively(p)) return;
    std::array<AtomId, 5> ids = in_order;
    random.shuffle(ids);
    const Side side = side_of(p, ids);
    const Balls turned{p[1], p[2], p[0], p[3], p[4]};
    CHECK(side_of(turned, {ids[1], ids[2], ids[0], ids[3], ids[4]}) == side);
    const Balls crossed{p[1], p[0], p[3], p[2], p[4]};
    CHECK(side_of(crossed, {ids[1], ids[0], ids[3], ids[2], ids[4]}) == side);
  });
}

TEST_CASE("a tie falls as a slightly larger weight of the smallest id makes it fall") {
  int ties = 0;
  support::for_seeds<Random>(4000, [&](Random& random) {
    Balls p = five([&] { return whole_ball(random, 1); });
    if (!orient_positively(p) || oracle_orthosphere(p) != Sign::Zero) return;
    ++ties;
    std::array<AtomId, 5> ids = in_order;
    random.shuffle(ids);
    const Side side = side_of(p, ids);
    for (std::size_t i = 0; i < 5; ++i) p[i].weight += std::exp2(-12.0 * (1 + ids[i].value));
    CHECK(side_of(p, ids) == side);
  });
  CHECK(ties > 50);
}

TEST_CASE("of two equal points the smaller id is inside every orthosphere through the other") {
  const auto corner = [](double x, double y, double z) { return WeightedPoint{{x, y, z}, 1}; };
  const Balls p{corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1), corner(0, 0, 0),
                corner(0, 0, 0)};
  REQUIRE(orientation_of(p) == Sign::Positive);
  CHECK(side_of(p, {AtomId(3u), AtomId(4u), AtomId(5u), AtomId(1u), AtomId(0u)}) == Side::Inside);
  CHECK(side_of(p, {AtomId(3u), AtomId(4u), AtomId(5u), AtomId(0u), AtomId(1u)}) == Side::Outside);
}

TEST_CASE("points on a line are collinear and their neighbours by one bit are not") {
  support::for_seeds<Random>(300, [&](Random& random) {
    const Point a = whole_ball(random, 50).position;
    const Point step = whole_ball(random, 50).position;
    CHECK(are_collinear(a, a + step, a - 3 * step));
    CHECK(are_collinear(a, a, a + step));
    Point off = a - 3 * step;
    off.x() = std::nextafter(off.x(), 1e9);
    CHECK(are_collinear(a, a + step, off) == (step.y() == 0 && step.z() == 0));
  });
}

TEST_CASE("expansions longer than their inline storage stay exact") {
  Expansion sum;
  Expansion reverse;
  std::vector<double> terms;
  for (int i = 0; i < 60; ++i) terms.push_back(std::ldexp(1.0, 16 * i - 480));
  for (const double term : terms) sum = sum + Expansion(term) * Expansion(3.0);
  for (auto term = terms.rbegin(); term != terms.rend(); ++term) {
    reverse = reverse + Expansion(*term) + Expansion(2 * *term);
  }
  CHECK((sum - reverse).sign() == Sign::Zero);
  CHECK((sum - reverse + Expansion(0x1p-700)).sign() == Sign::Positive);
  CHECK((sum * sum - reverse * reverse).sign() == Sign::Zero);
  CHECK((sum * sum - reverse * reverse - Expansion(0x1p-900)).sign() == Sign::Negative);
}

}  // namespace morskin::geometry
