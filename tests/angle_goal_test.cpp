#include "refine/angle_goal.h"

#include "tests/support/meshes.h"
#include "tests/support/molecules.h"

using namespace morskin;
using namespace morskin::certify;
using namespace morskin::refine;
using namespace morskin::support;

TEST_CASE("a triangle meets a goal if no angle is below the one bound and none above the other") {
  Random random(7);
  std::size_t met = 0;
  for (int k = 0; k < 20'000; ++k) {
    const double scale = std::pow(10, random.between(-6, 6));
    const auto corner = [&] { return Point(scale * random.in_cube(0, 1)); };
    const Point a = corner(), b = corner(), c = corner();
    const double min_deg = random.between(0, 60), max_deg = random.between(90, 180);
    const AngleRange angles = angle_range(a, b, c);
    const bool is_met = angles.smallest_deg >= min_deg && angles.largest_deg <= max_deg;
    if (std::abs(angles.smallest_deg - min_deg) < 1e-6) continue;
    if (std::abs(angles.largest_deg - max_deg) < 1e-6) continue;
    CHECK((AngleGoal(min_deg, max_deg).quality(a, b, c) >= 1) == is_met);
    met += is_met;
  }
  CHECK(met > 1000);
}

TEST_CASE("unless asked, angles are from 35 to 105 degrees up to C = 0.2, and from 30 on beyond") {
  const auto check = [](const PreparedSkin& skin) {
    for (const double C : {0.05, 0.08, 0.2, 0.21, 0.4}) {
      CAPTURE(C);
      const Sizing sizing{.C = C, .Q = Sizing::quality_for(C)};
      const MeshResult result = make_mesh(skin, {.sizing = sizing});
      CHECK(result.certificate.certified);
      CHECK(result.below_goal() == 0);
      CHECK(result.certificate.proved_angle_deg() >= (C <= 0.2 ? 35 : 30));
      if (C <= 0.2) CHECK(result.certificate.max_angle_deg <= 105);
    }
  };
  for_molecules({"cube8.xyzr", "benzene.pdb", "ring12.xyzr", "5tmn_ligand.pdb"},
                [&](const auto& balls) { check(prepare_skin(balls)); });
  for_skins(8, check);
}

TEST_CASE("where a triangle misses by little its surroundings make room for it") {
  // One of crambin's was left, and of 1K4C's one with more than 105 degrees.
  const PreparedSkin skin = prepare_skin(molecule("1crn.pdb", skin::Model::Paper));
  const MeshResult result = make_mesh(skin, {.sizing = {}, .angle_goal_deg = 40});
  CHECK(result.certificate.certified);
  CHECK(result.below_goal() == 0);
  CHECK(result.certificate.proved_angle_deg() >= 40);
}
