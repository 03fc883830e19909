#include "front/static_method.h"

#include "morskin/pipeline.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"

using namespace morskin;
using namespace morskin::support;

namespace {

MeshingOptions by_static_method(const certify::Sizing& sizing = {}) {
  return {.sizing = sizing, .method = Method::Static};
}

void check_certified(const std::vector<geometry::WeightedPoint>& points) {
  const Outcome outcome = outcome_of(points, by_static_method());
  CHECK_MESSAGE(outcome.kind == Outcome::Kind::Certified, outcome.why);
}

/// Random sets may have singular skins.
void check_static(const std::vector<geometry::WeightedPoint>& points) {
  const Outcome outcome = outcome_of(points, by_static_method());
  CHECK_MESSAGE(outcome.kind != Outcome::Kind::Failed, outcome.why);
}

}  // namespace

TEST_CASE("the static method meshes one ball, two with and without a neck, and nearly touching") {
  check_certified({ball(0, 0, 0, 1)});
  const double touching = 2 * std::sqrt(2.0);  // patches of radius 1 meet where spheres touch
  for (const double gap : {-1.0, -0.1, -1e-3, -1e-6, 1e-6, 1e-3, 0.1, 1.0, 100.0}) {
    CAPTURE(gap);
    check_certified({ball(0, 0, 0, 1), ball(touching + gap, 0, 0, 1)});
  }
}

TEST_CASE("the static method meshes small molecules in every model") {
  for_molecules({"benzene.pdb", "caffeine.xyz", "cube8.xyzr", "ring12.xyzr"}, check_certified);
}

TEST_CASE("the static method meshes inner voids") {
  check_certified(molecule("c60.xyz", skin::Model::Paper));
  check_certified(molecule("shell_hollow.xyzr", skin::Model::Sas));
}

TEST_CASE("the static method breaks what the certificate could not prove of a coarse mesh") {
  // Beyond C = 0.2 [U] alone lets triangles be too big for their length scale. With C = 0.35 two
  // sets of three had some.
  for_skins(20, [&](const PreparedSkin& skin) {
    for (const double C : {0.25, 0.35}) {
      CAPTURE(C);
      const MeshResult result = make_mesh(skin, by_static_method(sizing_for(C)));
      CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
    }
  });
}

TEST_CASE("the static method meshes a lattice whose samples have the atoms as circumcentres") {
  // An atom of this one lies within the walls of a far cell without volume, was outside of the skin
  // by the formula there, and its ball's tetrahedra made no surface.
  const Outcome outcome = outcome_of(nasty_set(4001983), by_static_method(sizing_for(0.3)));
  CHECK_MESSAGE(outcome.kind == Outcome::Kind::Certified, outcome.why);
}

TEST_CASE("where a neck is too narrow for the signs of G beside it the static method ends") {
  // A turned lattice, shrunk to five balls: samples were put into a neck of radius 3e-9 for ever.
  for (const double C : {0.25, 0.3}) {
    CAPTURE(C);
    const auto result =
        meshed({ball(5.084209190162315, -1.9682353223775713, -1.3096998037624372, 1.5),
                ball(7.404211399020838, -3.32446655565779, 1.1959391552192413, 1.5),
                ball(5.884546391227071, -4.7782390665531596, 0.9181555152183558, 1.5),
                ball(8.298465284292796, -3.717250446935805, -1.6406134713732061, 1.5),
                ball(6.7788002764990285, -5.171022957831174, -1.9183971113740914, 1.5)},
               by_static_method(sizing_for(C)));
    CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
    CHECK(result.fallbacks.empty());
  }
}

TEST_CASE("a small component beside a large one, nearer than the large length scale, is not lost") {
  // PDB entry 1BMF (wwPDB, CC0 1.0), to a hundredth of an Angstrom, model vdw: with C = 0.4 seeds
  // on the large component left the small one none.
  const auto result = meshed({ball(125.29, 66.03, 66.6, 1.7), ball(124.74, 66.11, 68.05, 1.7),
                              ball(121.19, 63.17, 68.04, 1.7), ball(122.25, 62.56, 68.06, 1.52),
                              ball(122.56, 63.66, 65.48, 1.52)},
                             by_static_method(sizing_for(0.4)));
  CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
}

TEST_CASE("samples too near to others, which the topology took, do not stay in a coarse mesh") {
  // With C = 0.4 an edge or two of crambin's broke [L].
  for (const skin::Model model : {skin::Model::Paper, skin::Model::Vdw}) {
    CAPTURE(std::string(skin::name_of(model)));
    const auto result = meshed(molecule("1crn.pdb", model), by_static_method(sizing_for(0.4)));
    CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
    CHECK(result.certificate.violations_L == 0);
  }
}

TEST_CASE("the static method gives the same bytes every time") {
  const auto points = molecule("caffeine.xyz", skin::Model::Paper);
  const auto first = meshed(points, by_static_method());
  meshed(ball_set(1), by_static_method());
  const auto second = meshed(points, by_static_method(), Run(2));
  CHECK(first.mesh == second.mesh);
}

TEST_CASE("the static method reports how many samples there are, more each time") {
  std::vector<std::size_t> reported;
  const Run run(1, [&](std::string_view stage, double) {
    std::size_t samples = 0;
    if (std::sscanf(std::string(stage).c_str(), "refine, %zu samples", &samples) == 1) {
      reported.push_back(samples);
    }
  });
  const auto result =
      meshed(molecule("caffeine.xyz", skin::Model::Vdw), by_static_method({.C = 0.04}), run);
  REQUIRE(reported.size() > 1);
  CHECK(std::ranges::is_sorted(reported));
  CHECK(std::ranges::adjacent_find(reported) == reported.end());
  CHECK(reported.back() <= result.mesh.positions.size());
  CHECK(2 * reported.back() > result.mesh.positions.size());
}

TEST_SUITE("slow") {
  TEST_CASE("the static method meshes the molecules of Table 1 and more in every model") {
    for_molecules({"5tmn_ligand.pdb", "9dna.pdb", "1grm_model1.pdb", "1crn.pdb", "c60.xyz",
                   "shell_hollow.xyzr", "two_balls.xyzr"},
                  check_certified);
  }
  TEST_CASE("the static method certifies 600 nasty and 200 random ball sets") {
    for_seeds(600, [&](unsigned seed) { check_static(nasty_set(seed)); });
    for_seeds(200, [&](unsigned seed) { check_static(ball_set(seed)); });
  }
}
