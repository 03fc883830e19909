// Balls of very different sizes, or far out: meshed and certified, or refused before any work.

#include "morskin/prepared_skin.h"
#include "tests/support/outcome.h"
#include "tests/support/test.h"

using namespace morskin;
using support::ball;
using support::WeightedPoints;

namespace {

/// Two balls of a radius whose spheres overlap by a share of their distance, about a point.
WeightedPoints pair(double radius, double overlap, const geometry::Point& at) {
  const double distance = 2 * std::sqrt(2.0) * radius * (1 - overlap);
  return {ball(at.x(), at.y(), at.z(), radius), ball(at.x() + distance, at.y(), at.z(), radius)};
}

bool is_certified(const WeightedPoints& points) {
  const support::Outcome outcome = support::outcome_of(points);
  INFO(outcome.why);
  return outcome.kind == support::Outcome::Kind::Certified;
}

}  // namespace

TEST_CASE("two balls of any size are joined or apart as their weights say, to the last digits") {
  for (const double radius : {1e-20, 1e-17, 1e-9, 1e-6, 1.0, 1e4}) {
    CAPTURE(radius);
    for (const double overlap : {2e-9, -2e-9}) {
      const PreparedSkin skin = prepare_skin(pair(radius, overlap, {0, 0, 0}));
      CHECK(skin.topology.skin_components() == (overlap > 0 ? 1 : 2));
    }
  }
}

TEST_CASE("tiny balls that share skin are refused beside a far one, which the refusal names") {
  WeightedPoints points = pair(1e-6, 2e-9, {0, 0, 0});
  points.push_back(ball(1e6, 0, 0, 1));
  try {
    prepare_skin(points);
    FAIL("not refused");
  } catch (const ScalesTooFarApart& apart) {
    CHECK(apart.small.value < 2);
    CHECK(apart.largest == geometry::AtomId(2u));
  }
  // Moved apart, they have no wall near the skin.
  points[1].position.x() = 1e-3;
  CHECK(is_certified(points));
}

TEST_CASE("a ball by itself is meshed where its critical points can be told apart, or refused") {
  CHECK(is_certified({ball(1000, 0, 0, 1e-9)}));
  for (const double radius : {2e-10, 1e-12, 1e-18}) {
    CAPTURE(radius);
    const WeightedPoints alone{ball(1000, 0, 0, radius)};
    CHECK_THROWS_WITH_AS(prepare_skin(alone),
                         "weighted point 0 has a patch over 2^36 times smaller than its largest "
                         "coordinate: doubles cannot carry both; move it to the origin",
                         ScalesTooFarApart);
    try {
      prepare_skin({ball(0, 0, 0, radius), ball(1000, 0, 0, 1)});
      FAIL("not refused");
    } catch (const ScalesTooFarApart& apart) {
      CHECK(apart.small == geometry::AtomId(0u));
      CHECK(apart.largest == geometry::AtomId(1u));
    }
    CHECK(is_certified({ball(1000, 0, 0, 1), ball(1000.5, 0, 0, radius)}));  // inside: no skin
  }
}

TEST_CASE("necks and gaps are meshed as thin as coordinates resolve, and thinner ones refused") {
  const double a = 0x1.8p0 + 0x1p-33;
  const double gap = a * a, neck = std::nextafter(gap, 10.0);  // weights
  const double width = std::fma(a, a, -gap);
  REQUIRE(width > 0);
  REQUIRE(width < 1e-19);
  for (const double w : {gap, neck}) {
    CAPTURE(w);
    for (const double far : {1.0, 32.0, 1e9}) {
      CAPTURE(far);
      const WeightedPoints points{{geometry::Point(-a, far, 0), w},
                                  {geometry::Point(a, far, 0), w}};
      if (far > 1e6) {
        CHECK_THROWS_AS(prepare_skin(points), geometry::RefusedInput);
      } else {
        CHECK(is_certified(points));
      }
    }
  }
}

TEST_CASE("whatever scales coordinates in Angstrom may have, they are no reason for a refusal") {
  const std::vector<double> gaps{1e-3, -1e-3, 1e-6, -1e-6, 1e-8, -1e-8};
  for (const double gap : gaps) {
    CAPTURE(gap);
    CHECK(is_certified(pair(1, gap, {0, 0, 0})));
    WeightedPoints beside = pair(1, gap, {0, 0, 0});
    beside.push_back(ball(1e6, 1e6, 1e6, 1));
    CHECK(is_certified(beside));
  }
  CHECK(is_certified(pair(1, 0.3, {1e6, -1e6, 1e6})));
  WeightedPoints small = pair(0.01, 0.3, {1e4, 1e4, -1e4});
  small.push_back(ball(0, 0, 0, 1));
  CHECK(is_certified(small));
  CHECK(is_certified({ball(0, 0, 0, 1e4), ball(14143.5, 0, 0, 1)}));
  CHECK(is_certified({ball(1e6, 0, 0, 1e-6)}));
}
