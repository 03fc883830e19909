#include "morskin/pipeline.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"

using namespace morskin;
using namespace morskin::support;

namespace {

void check_promise(const std::vector<geometry::WeightedPoint>& points,
                   const MeshingOptions& options = {}) {
  const Outcome outcome = outcome_of(points, options);
  CHECK_MESSAGE(outcome.kind != Outcome::Kind::Failed, outcome.why);
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("2,000 random ball sets are certified or refused as singular") {
    for_seeds(2000, [&](unsigned seed) { check_promise(ball_set(seed)); });
  }

  TEST_CASE("1,200 nasty ball sets of all kinds are certified or refused as singular") {
    for_seeds(1200, [&](unsigned seed) {
      CAPTURE(std::string(nasty_names[seed % nasty_kinds]));
      check_promise(nasty_set(seed));
    });
  }

  TEST_CASE("100 random ball sets are certified in five random directions each") {
    for_seeds(100, [&](unsigned seed) {
      const auto points = ball_set(seed);
      Random random(seed + 5000);
      for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        check_promise(points, along(random.direction()));
      }
    });
  }
}
