#include "morskin/size_goal.h"

#include "morskin/bent_part.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;

namespace {

MeshingOptions coarse(const SizeGoal& goal) {
  constexpr double C = certify::Sizing::coarsest_C;
  return {.sizing = {.C = C, .Q = certify::Sizing::quality_for(C)}, .size_goal = goal};
}

double density(const MeshResult& result) {
  return static_cast<double>(result.mesh.positions.size()) / result.certificate.area;
}

}  // namespace

TEST_CASE("a density is met within a tenth where the skin allows it, and the mesh certified") {
  std::size_t met = 0;
  for_molecules({"5tmn_ligand.pdb", "9dna.pdb"}, [&](const auto& balls) {
    const PreparedSkin skin = prepare_skin(balls);
    const double least = density(make_mesh(skin, coarse({})));
    for (const double wanted : {1., 2., 5., 10., 20.}) {
      CAPTURE(wanted);
      const MeshResult result = make_mesh(skin, coarse({.density = wanted, .triangles = {}}));
      CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
      CHECK(result.certificate.proved_angle_deg() >= 30);
      if (wanted < 1.2 * least) {
        CHECK(density(result) <= 1.2 * least);
        continue;
      }
      CHECK(std::abs(density(result) / wanted - 1) <= 0.1);
      ++met;
    }
  });
  CHECK(met > 10);
}

TEST_CASE("a number of triangles is met within a tenth, one too small gives fewer than C alone") {
  const PreparedSkin skin = prepare_skin(molecule("5tmn_ligand.pdb", skin::Model::Vdw));
  const std::size_t least = make_mesh(skin, coarse({})).mesh.triangles.size();
  for (const double wanted : {2000., 10'000., 60'000.}) {
    const MeshResult result = make_mesh(skin, coarse({.density = {}, .triangles = wanted}));
    CHECK(std::abs(static_cast<double>(result.mesh.triangles.size()) / wanted - 1) <= 0.1);
    CHECK(result.certificate.certified);
  }
  const MeshResult fewest = make_mesh(skin, coarse({.density = {}, .triangles = 4}));
  CHECK(fewest.certificate.certified);
  CHECK(fewest.mesh.triangles.size() < least);
  CHECK(2 * fewest.mesh.triangles.size() > least);
}

TEST_CASE("where the skin bends, at most 1.3 times the triangles that the proof forces are left") {
  std::size_t bent_skins = 0;
  for_molecules({"5tmn_ligand.pdb", "9dna.pdb"}, [&](const auto& balls) {
    const PreparedSkin skin = prepare_skin(balls);
    for (const double wanted : {1., 2., 5.}) {
      const MeshResult result = make_mesh(skin, coarse({.density = wanted, .triangles = {}}));
      const BentPart bent = bent_part(skin.surface, result);
      CAPTURE(bent.triangles);
      CHECK(bent.area_share <= 1 + 1e-12);
      if (bent.area_share < 0.1) continue;
      CHECK(bent.triangles < 1.3 * bent.forced_triangles);
      ++bent_skins;
    }
  });
  CHECK(bent_skins > 2);
}

TEST_CASE("a ball forces 1.7 times 4 pi triangles, however coarse the mesh that tells") {
  const PreparedSkin skin = prepare_skin({ball(0, 0, 0, 2)});
  const double largest_share = 3 * std::sqrt(3) / 4 * 0.68 * 0.68;
  for (const double C : {0.05, 0.1, 0.2}) {
    CAPTURE(C);
    const MeshResult result = make_mesh(skin, {.sizing = {.C = C}});
    const BentPart bent = bent_part(skin.surface, result);
    CHECK(bent.area_share == doctest::Approx(1));
    CHECK(bent.triangles == doctest::Approx(static_cast<double>(result.mesh.triangles.size())));
    CHECK(bent.forced_triangles == doctest::Approx(4 * M_PI / largest_share).epsilon(0.01));
  }
}

TEST_CASE("sizes that make no sense are refused") {
  const PreparedSkin skin = prepare_skin({ball(0, 0, 0, 1)});
  for (const SizeGoal& goal : {SizeGoal{1, 100}, SizeGoal{0, {}}, SizeGoal{-1, {}},
                               SizeGoal{std::nan(""), {}}, SizeGoal{{}, 3}, SizeGoal{{}, 1e12}}) {
    CHECK_THROWS_AS(make_mesh(skin, coarse(goal)), geometry::RefusedInput);
  }
}
