#include <doctest/doctest.h>

#include <string>

#include "morskin/pipeline.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"
#include "tests/support/seeds.h"

using namespace morskin;

namespace {

void check_promise(const std::vector<geometry::WeightedPoint>& points,
                   const morskin::MeshingOptions& options = {}) {
  const support::Outcome outcome = support::outcome_of(points, options);
  CHECK_MESSAGE(outcome.kind != support::Outcome::Kind::Failed, outcome.why);
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("2,000 random ball sets are certified or refused as singular") {
    support::for_seeds(2000, [&](unsigned seed) { check_promise(support::ball_set(seed)); });
  }

  TEST_CASE("1,200 nasty ball sets of all kinds are certified or refused as singular") {
    support::for_seeds(1200, [&](unsigned seed) {
      CAPTURE(std::string(support::nasty_names[seed % support::nasty_kinds]));
      check_promise(support::nasty_set(seed));
    });
  }

  TEST_CASE("100 random ball sets are certified in five random directions each") {
    support::for_seeds(100, [&](unsigned seed) {
      const auto points = support::ball_set(seed);
      support::Random random(seed + 5000);
      for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        check_promise(points, support::along(random.direction()));
      }
    });
  }
}
