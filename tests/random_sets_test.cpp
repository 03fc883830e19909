#include "morskin/pipeline.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"

using namespace morskin;
using namespace morskin::support;

namespace {

/// How many sets came out how.
struct Counts {
  std::size_t certified = 0, singular = 0;

  void check_promise(const std::vector<geometry::WeightedPoint>& points,
                     const MeshingOptions& options = {}) {
    const Outcome outcome = outcome_of(points, options);
    CHECK_MESSAGE(outcome.kind != Outcome::Kind::Failed, outcome.why);
    certified += outcome.kind == Outcome::Kind::Certified;
    singular += outcome.kind == Outcome::Kind::Singular;
  }
};

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("2,000 random ball sets are certified or refused as singular") {
    Counts counts;
    for_seeds(2000, [&](unsigned seed) { counts.check_promise(ball_set(seed)); });
    CHECK(counts.certified > 1900);
  }

  TEST_CASE("1,200 nasty ball sets of all kinds are certified or refused as singular") {
    Counts counts;
    for_seeds(1200, [&](unsigned seed) {
      CAPTURE(std::string(nasty_names[seed % nasty_kinds]));
      counts.check_promise(nasty_set(seed));
    });
    CHECK(counts.certified > 1100);
    CHECK(counts.singular > 0);
  }

  TEST_CASE("100 random ball sets are certified in five random directions each") {
    Counts counts;
    for_seeds(100, [&](unsigned seed) {
      const auto points = ball_set(seed);
      Random random(seed + 5000);
      for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        counts.check_promise(points, along(random.direction()));
      }
    });
    CHECK(counts.certified == 500);
  }
}
