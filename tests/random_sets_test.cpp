#include <doctest/doctest.h>

#include "front/mesh_skin.h"
#include "tests/support/meshes.h"

using namespace morskin;

namespace {

void check_certified(const front::MeshResult& result) {
  CHECK(result.certificate.reason == "");
  CHECK(result.certificate.certified);
  CHECK(result.certificate.min_angle_deg > 21.54);
  CHECK(result.certificate.euler_characteristic ==
        static_cast<long>(result.minima + result.maxima) - static_cast<long>(result.saddles));
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("2,000 random ball sets are certified or refused as singular") {
    for (unsigned seed = 0; seed < 2000; ++seed) {
      CAPTURE(seed);
      const auto skin = support::prepared(support::ball_set(seed));
      if (skin) check_certified(front::mesh_skin(*skin));
    }
  }

  TEST_CASE("100 random ball sets are certified in five random directions each") {
    for (unsigned seed = 0; seed < 100; ++seed) {
      CAPTURE(seed);
      const auto skin = support::prepared(support::ball_set(seed));
      if (!skin) continue;
      support::Random random(seed + 5000);
      for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        check_certified(front::mesh_skin(*skin, support::along(random.direction())));
      }
    }
  }
}
