#include <doctest/doctest.h>

#include <string>

#include "morskin/pipeline.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"

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
    for (unsigned seed = 0; seed < 2000; ++seed) {
      CAPTURE(seed);
      check_promise(support::ball_set(seed));
    }
  }

  TEST_CASE("1,200 nasty ball sets of all kinds are certified or refused as singular") {
    for (unsigned seed = 0; seed < 1200; ++seed) {
      CAPTURE(seed);
      CAPTURE(std::string(support::nasty_names[seed % support::nasty_kinds]));
      check_promise(support::nasty_set(seed));
    }
  }

  TEST_CASE("100 random ball sets are certified in five random directions each") {
    for (unsigned seed = 0; seed < 100; ++seed) {
      CAPTURE(seed);
      const auto points = support::ball_set(seed);
      support::Random random(seed + 5000);
      for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        check_promise(points, support::along(random.direction()));
      }
    }
  }
}
