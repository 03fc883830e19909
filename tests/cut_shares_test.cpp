#include "skin/void_volume_internal.h"
#include "tests/support/ball_sets.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::Vector;

namespace {

/// The share of points of a grid in the cube where G, if linear, is positive.
double counted_share(const Vector& half_gradient, double at_centre, double half_side) {
  constexpr int n = 24;
  int positive = 0;
  for (int k = 0; k < n * n * n; ++k) {
    const Vector place(k % n, k / n % n, k / (n * n));
    const Vector to = half_side * ((2 * place + Vector::Ones()) / n - Vector::Ones());
    positive += at_centre + 2 * half_gradient.dot(to) > 0;
  }
  return positive / static_cast<double>(n * n * n);
}

}  // namespace

TEST_CASE("the shares of a cube that surely and perhaps lie outside are those that one counts") {
  support::for_seeds(300, [](unsigned seed) {
    support::Random random(seed);
    const double half_side = std::pow(10.0, random.between(-3, 3));
    Vector N = random.direction();
    for (int k = 0; k < 3; ++k) {
      if (random.uniform() < 0.2) N[k] *= 1e-4;  // so that planes are nearly parallel to edges
    }
    const double largest = 2 * half_side * N.lpNorm<1>();  // change of G from centre to corner
    const double slack = random.between(0, 0.3) * largest;
    const double low = random.between(-1, 1) * largest;
    const double high = low + random.between(0, 0.2) * largest;
    const skin::VolumeBounds found = skin::cut_shares({low, high, N, 0}, half_side, slack);
    constexpr double grid = 0.03;  // a layer of the grid, less what a plane through it has of it
    const double surely = counted_share(N, low - slack, half_side);
    const double perhaps = counted_share(N, high + slack, half_side);
    CHECK(std::abs(found.low - surely) < grid);
    CHECK(std::abs(found.high - perhaps) < grid);
    CHECK(found.low >= 0);
    CHECK(found.high <= 1);
  });
}

TEST_CASE("a plane along two sides of a cube cuts it at its distance from the centre") {
  for (const double share : {0.0, 0.1, 0.5, 0.75, 1.0}) {
    for (int k = 0; k < 3; ++k) {
      for (const double sign : {-1.0, 1.0}) {
        const double value = 4 * (share - 0.5);  // N is 1, and so is half a side
        const auto found = skin::cut_shares({value, value, sign * Vector::Unit(k), 0}, 1, 0);
        CHECK(found.low <= share);
        CHECK(found.high >= share);
        CHECK(found.high - found.low < 4e-3);  // the two other widths are a thousandth
      }
    }
  }
}
