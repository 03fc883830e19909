#include "skin/least_power.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/exact_range.h"
#include "geometry/regular_triangulation.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/powers.h"
#include "tests/support/seeds.h"

using namespace morskin;
using geometry::AtomId;
using geometry::Point;
using geometry::WeightedPoint;
using support::power;

namespace {

/// A point where some of the atoms tie, or any other.
Point some_point(support::Random& random, const std::vector<WeightedPoint>& points) {
  const WeightedPoint& a = points[random.below(points.size())];
  const WeightedPoint& b = points[random.below(points.size())];
  const Point between = a.position + random.between(-0.5, 1.5) * (b.position - a.position);
  if (random.below(2) == 0) return between;
  const double reach = std::sqrt(std::abs(a.weight)) * std::pow(10.0, random.between(-6, 1));
  return between + reach * random.direction();
}

}  // namespace

TEST_CASE("no atom has less power than the bound, whichever few are tried, on any set of balls") {
  std::size_t missed = 0;  // tries without an atom of least power
  support::for_seeds(1500, [&](unsigned seed) {
    std::vector<WeightedPoint> points =
        seed % 3 == 0 ? support::ball_set(seed) : support::nasty_set(seed);
    geometry::move_to_exact_grid(points);
    const auto triangulation = geometry::regular_triangulation(points);
    const skin::LeastPower powers(points, triangulation.edges);
    support::Random random(seed);
    for (int i = 0; i < 12; ++i) {
      const Point q = some_point(random, points);
      long double least = std::numeric_limits<long double>::infinity(), size = 0;
      for (const WeightedPoint& p : points) least = std::min(least, power(p, q));
      // Those of least power and others, hidden ones and repeated ones among them.
      std::vector<AtomId> tried;
      for (std::uint32_t a = 0; a < points.size(); ++a) {
        if (tried.size() < 4 && power(points[a], q) <= least + 1e-9L * std::abs(least)) {
          tried.push_back(AtomId{a});
        }
      }
      if (i % 2 == 0 || tried.empty()) tried = {AtomId{random.below(points.size())}};
      if (i % 3 == 0) tried.push_back(AtomId{random.below(points.size())});
      const auto found = powers.at(q, tried);
      const WeightedPoint& nearest = points[found.atom.index()];
      size = power(nearest, q) + nearest.weight + std::abs(nearest.weight);
      for (const AtomId a : tried)
        size = std::max<long double>(size, std::abs(points[a.index()].weight));
      CHECK(found.lower_bound <= least + 0x1p-62L * size);
      CHECK(found.lower_bound >= least - 0x1p-48L * size - 0x1p-900L);
      const skin::Vector3<skin::Quad> in_quad = q.cast<skin::Quad>();
      const auto close = powers.at(in_quad, tried);
      CHECK(static_cast<long double>(close.lower_bound) <= least + 0x1p-62L * size);
      CHECK(static_cast<long double>(close.lower_bound) >= least - 0x1p-60L * size);
      missed += std::ranges::all_of(
          tried, [&](AtomId a) { return power(points[a.index()], q) > least + 0x1p-50L * size; });
    }
  });
  CHECK(missed > 3000);
}

TEST_CASE("the walk to the nearest atom ends where no power is a number") {
  const std::vector<WeightedPoint> points = support::ball_set(1);
  const auto triangulation = geometry::regular_triangulation(points);
  const skin::LeastPower powers(points, triangulation.edges);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const AtomId start = triangulation.vertices.front();
  CHECK(powers.nearest(Point(nan, 0, 0), start) == start);
}
