// What a certificate asks of angles and sizes beside the proof.

#include "certify/certificate.h"
#include "tests/support/good_mesh.h"

using namespace morskin;

TEST_CASE("a mesh is certified for its angles, by [L] or each by itself") {
  const support::Good good({support::ball(0, 0, 0, 1)});
  const double smallest = good.certify(good.mesh).min_angle_deg;
  REQUIRE(smallest > 30);
  const auto certified_with = [&](certify::Sizing sizing, double claimed_deg) {
    sizing.claimed_angle_deg = claimed_deg;
    return certify::certify(good.mesh, good.skin.surface, good.skin.topology, sizing);
  };
  // With a small Q all edges are too short for [L], with a large C no triangle too big for [U].
  constexpr certify::Sizing all_short{.C = 0.3, .Q = 1.2};
  for (const double claimed : {0.0, smallest - 1e-9}) {
    CHECK(certified_with({}, claimed).certified);
    const certify::Certificate c = certified_with(all_short, claimed);
    CHECK(c.violations_L > 0);
    CHECK_MESSAGE(c.certified, c.reason);
  }
  for (const certify::Sizing& sizing : {certify::Sizing{}, all_short}) {
    const certify::Certificate c = certified_with(sizing, smallest + 1e-9);
    CHECK(c.is_homeomorphic);
    CHECK_FALSE(c.certified);
    CHECK_MESSAGE(support::contains(c.reason, "has an angle of"), c.reason);
    CHECK(c.proved_angle_deg() <= smallest + 1e-12);
    CHECK(c.proved_angle_deg() > smallest - 1e-9);
  }
}
