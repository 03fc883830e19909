#include "skin/power_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/ball_sets.h"
#include "tests/support/powers.h"
#include "tests/support/seeds.h"

using namespace morskin;
using geometry::Point;
using geometry::WeightedPoint;
using support::power;

namespace {

/// Up to 300 atoms of some scale, in a box about some centre; every third is a copy of another but
/// for its weight, and weights go from far below zero to far above.
std::vector<WeightedPoint> atoms(support::Random& random, double scale, const Point& centre) {
  std::vector<WeightedPoint> result;
  const std::size_t count = 1 + random.below(300);
  while (result.size() < count) {
    WeightedPoint atom{centre + scale * random.between(0, 10) * random.direction(),
                       scale * scale * random.between(-5, 20)};
    if (!result.empty() && random.below(3) == 0) {
      atom.position = result[random.below(result.size())].position;
    }
    result.push_back(atom);
  }
  return result;
}

}  // namespace

TEST_CASE("no atom has less power than the tree's bound, and the bound is the least to rounding") {
  for (const double scale : {1e-9, 1e-3, 1.0, 1e6}) {
    CAPTURE(scale);
    for (const double shift : {0.0, 1e3, 1e6}) {
      CAPTURE(shift);
      support::for_seeds(40, [&](unsigned seed) {
        support::Random random(seed);
        const Point centre = shift * random.direction();
        const auto points = atoms(random, scale, centre);
        const skin::PowerTree tree(points);
        for (int i = 0; i < 50; ++i) {
          const Point q = i == 0
                              ? points[0].position
                              : Point(centre + scale * random.between(0, 20) * random.direction());
          const geometry::AtomId guess{random.below(points.size())};
          const skin::PowerTree::Least found = tree.least(q, guess, points[guess.index()]);
          long double least = std::numeric_limits<long double>::infinity(), size = 0;
          for (const WeightedPoint& atom : points) least = std::min(least, power(atom, q));
          const WeightedPoint& nearest = points[found.atom.index()];
          size = power(nearest, q) + nearest.weight + std::abs(nearest.weight);
          CHECK(found.lower_bound <= least);
          CHECK(found.lower_bound >= least - 0x1p-48L * size - 0x1p-900L);
          CHECK(power(nearest, q) <= least + 0x1p-48L * size + 0x1p-900L);
        }
      });
    }
  }
}

TEST_CASE("in quadruple precision too no atom has less power than the bound, close as they are") {
  using skin::Quad;
  support::for_seeds(60, [&](unsigned seed) {
    support::Random random(seed);
    const double scale = std::pow(10.0, random.between(-6, 3));
    const Point centre = std::pow(10.0, random.between(-3, 6)) * random.direction();
    auto points = atoms(random, scale, centre);
    for (int i = 0; i < 30; ++i) {
      // Weights that make all powers at q equal but for the last digits of doubles.
      const Point near = centre + scale * random.between(0, 20) * random.direction();
      if (i % 2 == 0) {
        for (WeightedPoint& p : points) p.weight = (p.position - near).squaredNorm();
      }
      const skin::PowerTree tree(points);
      const skin::Vector3<Quad> q =
          near.cast<Quad>() +
          skin::Vector3<Quad>::Constant(Quad(random.between(-1, 1)) * 0x1p-60 * Quad(near.norm()));
      Quad least = 1e300;
      for (const WeightedPoint& p : points) {
        const skin::Vector3<Quad> d = p.position.cast<Quad>() - q;
        least = std::min(least, Quad(d.dot(d)) - Quad(p.weight));
      }
      const geometry::AtomId guess{random.below(points.size())};
      const auto found = tree.least(q, guess, points[guess.index()]);
      const double size = std::pow(30 * scale, 2);
      CHECK(found.lower_bound <= least + 0x1p-110 * size);
      CHECK(found.lower_bound >= least - 0x1p-108 * size);
    }
  });
}
