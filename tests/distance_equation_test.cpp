#include "morse/distance_equation.h"

#include <Eigen/Eigenvalues>
#include <complex>

#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;

namespace {

constexpr double no_rounding = 0x1p-52;

/// The equation without its denominators, the quartic
/// A (1 + m)^2 - B (1 - m)^2 - W (1 - m^2)^2: its real roots from the companion matrix.
std::vector<double> quartic_roots(double A, double B, double W) {
  // (1 - m^2)^2 = m^4 - 2 m^2 + 1
  const std::array<double, 5> c{A - B - W, 2 * (A + B), A - B + 2 * W, 0, -W};
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 3; ++i) companion(i + 1, i) = 1;
  for (int i = 0; i < 4; ++i) companion(i, 3) = -c[static_cast<std::size_t>(i)] / c[4];
  std::vector<double> roots;
  for (const std::complex<double> m : companion.eigenvalues()) {
    if (std::abs(m.imag()) < 1e-7 * std::abs(m)) roots.push_back(m.real());
  }
  std::sort(roots.begin(), roots.end());
  return roots;
}

/// A length over many orders of magnitude.
double length(Random& random) { return std::pow(10.0, random.between(-6, 6)); }

}  // namespace

TEST_CASE("solutions of the distance equation are on the quadric, with the gradient normal to it") {
  std::size_t solutions = 0;
  for_seeds<Random>(20000, [&](unsigned seed, Random& random) {
    const double across = seed % 11 == 0 ? 0 : length(random);
    const double along = seed % 7 == 0 ? 0 : (seed % 2 ? 1 : -1) * length(random);
    const double W = (random.uniform() < 0.5 ? 1 : -1) * length(random);
    const auto points =
        distance_equation(across, along, W, no_rounding * (across + std::abs(along)));
    for (const MeridianPoint& p : points) {
      ++solutions;
      const double rho_squared = p.across * p.across + p.along * p.along;
      CHECK(std::abs(p.across * p.across - p.along * p.along - W) <= 1e-14 * rho_squared);
      CHECK(std::abs(p.one_minus_m * p.across - across) <= 4e-16 * across);
      CHECK(std::abs(p.one_plus_m * p.along - along) <= 4e-16 * std::abs(along));
      CHECK(p.one_minus_m + p.one_plus_m == doctest::Approx(2));
      CHECK(p.is_circle == (p.one_minus_m == 0 && p.across != 0));
    }
  });
  CHECK(solutions > 20000);
}

TEST_CASE("no solution of the distance equation is missed: an eigenvalue solver finds no others") {
  std::array<std::size_t, 5> met{};
  for_seeds<Random>(20000, [&](unsigned seed, Random& random) {
    const double across = random.between(0.01, 4), along = random.between(-4, 4);
    const double W = (seed % 2 ? 1 : -1) * random.between(0.05, 4);
    const auto points = distance_equation(across, along, W, no_rounding);
    std::vector<double> m;
    for (const MeridianPoint& p : points) m.push_back(1 - p.one_minus_m);
    std::sort(m.begin(), m.end());
    for (std::size_t i = 1; i < m.size(); ++i) CHECK(m[i] > m[i - 1]);
    const std::vector<double> expected = quartic_roots(across * across, along * along, W);
    // Where two roots nearly meet the matrix may make them complex; the tangency is told by one.
    const bool is_tangent =
        std::abs(std::cbrt(across * across) - std::cbrt(along * along) - std::cbrt(4 * W)) < 1e-5;
    if (is_tangent) return;
    REQUIRE(m.size() == expected.size());
    ++met[m.size()];
    for (std::size_t i = 0; i < m.size(); ++i) {
      CHECK(std::abs(m[i] - expected[i]) <= 1e-6 * (1 + std::abs(m[i])));
    }
  });
  CHECK(met[2] > 1000);
  CHECK(met[4] > 500);
}

TEST_CASE("on the axis a circle, in the plane of symmetry two points stand for two of the roots") {
  for (const double along : {0.5, 3.0, -3.0}) {
    CAPTURE(along);
    const auto neck = distance_equation(0, along, 1, no_rounding);  // one sheet about the axis
    REQUIRE(neck.size() == 1);
    CHECK(neck.begin()[0].is_circle);
    CHECK(neck.begin()[0].across == doctest::Approx(std::sqrt(1 + along * along / 4)));

    const auto caps = distance_equation(0, along, -1, no_rounding);  // two sheets
    const bool beyond_focus = std::abs(along) > 2;
    REQUIRE(caps.size() == (beyond_focus ? 3U : 2U));
    std::size_t circles = 0;
    for (const MeridianPoint& p : caps) {
      circles += p.is_circle;
      if (!p.is_circle) CHECK(std::abs(p.along) == doctest::Approx(1));
    }
    CHECK(circles == beyond_focus);
  }
  for (const double across : {0.5, 3.0}) {
    CAPTURE(across);
    const auto neck = distance_equation(across, 0, 1, no_rounding);
    CHECK(neck.size() == (across > 2 ? 4U : 2U));
    const auto caps = distance_equation(across, 0, -1, no_rounding);
    REQUIRE(caps.size() == 2);
    for (const MeridianPoint& p : caps) {
      CHECK(p.across == across / 2);
      CHECK(std::abs(p.along) == doctest::Approx(std::sqrt(1 + across * across / 4)));
    }
  }
}

TEST_CASE(
    "where rounding decides whether two solutions exist, the place where they meet is given") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double along = random.between(0.1, 3), across = random.between(0.1, 3);
    // On the evolute: across^(2/3) - along^(2/3) = (4 W)^(1/3).
    const double root = std::cbrt(across * across) - std::cbrt(along * along);
    if (std::abs(root) < 0.01) continue;
    const double W = root * root * root / 4;
    const auto points = distance_equation(across, along, W, 0x1p-48);
    REQUIRE(points.size() == 3);
    std::size_t flat = 0;
    for (const MeridianPoint& p : points) {
      const double lambda = p.one_plus_m * p.across * p.across + p.one_minus_m * p.along * p.along;
      flat += std::abs(lambda) < 1e-9 * (p.across * p.across + p.along * p.along);
    }
    CHECK(flat == 1);
  }
}
