#include "front/static_method.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "morskin/pipeline.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"

using namespace morskin;
using support::Outcome;

namespace {

MeshingOptions by_static_method() {
  MeshingOptions options;
  options.method = Method::Static;
  return options;
}

void check_static(const std::vector<geometry::WeightedPoint>& points) {
  const Outcome outcome = support::outcome_of(points, by_static_method());
  CHECK_MESSAGE(outcome.kind != Outcome::Kind::Failed, outcome.why);
}

constexpr std::array all_models{skin::Model::Paper, skin::Model::Sas, skin::Model::Vdw};

void check_molecule(const char* file) {
  CAPTURE(std::string(file));
  for (const skin::Model model : all_models) {
    CAPTURE(std::string(skin::name_of(model)));
    check_static(support::molecule(file, model));
  }
}

}  // namespace

TEST_CASE("the static method meshes one ball, two with and without a neck, and nearly touching") {
  check_static({support::ball(0, 0, 0, 1)});
  const double touching = 2 * std::sqrt(2.0);  // patches of radius 1 meet where spheres touch
  for (const double gap : {-1.0, -0.1, -1e-3, -1e-6, 1e-6, 1e-3, 0.1, 1.0, 100.0}) {
    CAPTURE(gap);
    check_static({support::ball(0, 0, 0, 1), support::ball(touching + gap, 0, 0, 1)});
  }
}

TEST_CASE("the static method meshes small molecules in every model") {
  for (const char* file : {"benzene.pdb", "caffeine.xyz", "cube8.xyzr", "ring12.xyzr"}) {
    check_molecule(file);
  }
}

TEST_CASE("the static method meshes inner voids") {
  check_static(support::molecule("c60.xyz", skin::Model::Paper));
  check_static(support::molecule("shell_hollow.xyzr", skin::Model::Sas));
}

TEST_CASE("the static method breaks what the certificate could not prove of a coarse mesh") {
  // Beyond C = 0.2 [U] alone lets triangles be too big for their length scale. With C = 0.35 two
  // sets of three had some.
  support::for_skins(20, [&](const PreparedSkin& skin) {
    for (const double C : {0.25, 0.35}) {
      CAPTURE(C);
      MeshingOptions options = by_static_method();
      options.sizing = {C, certify::Sizing::quality_for(C)};
      const morskin::MeshResult result = morskin::make_mesh(skin, options);
      CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
    }
  });
}

TEST_CASE("samples too near to others, which the topology took, do not stay in a coarse mesh") {
  // With C = 0.4 an edge or two of crambin's broke [L].
  for (const skin::Model model : {skin::Model::Paper, skin::Model::Vdw}) {
    CAPTURE(std::string(skin::name_of(model)));
    MeshingOptions options = by_static_method();
    options.sizing = {0.4, certify::Sizing::quality_for(0.4)};
    const auto result = support::meshed(support::molecule("1crn.pdb", model), options);
    CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
    CHECK(result.certificate.violations_L == 0);
  }
}

TEST_CASE("the static method gives the same bytes every time") {
  const auto points = support::molecule("caffeine.xyz", skin::Model::Paper);
  const auto first = support::meshed(points, by_static_method());
  support::meshed(support::ball_set(1), by_static_method());
  const auto second = support::meshed(points, by_static_method(), morskin::Run(2));
  CHECK(first.mesh.triangles == second.mesh.triangles);
  CHECK(first.mesh.positions == second.mesh.positions);
}

TEST_CASE("the static method tells how many samples there are, more each time") {
  std::vector<std::size_t> told;
  MeshingOptions options = by_static_method();
  options.sizing.C = 0.04;
  const morskin::Run run(1, [&](std::string_view stage, double) {
    std::size_t samples = 0;
    if (std::sscanf(std::string(stage).c_str(), "refine, %zu samples", &samples) == 1) {
      told.push_back(samples);
    }
  });
  const auto result =
      support::meshed(support::molecule("caffeine.xyz", skin::Model::Vdw), options, run);
  REQUIRE(told.size() > 1);
  CHECK(std::ranges::is_sorted(told));
  CHECK(std::ranges::adjacent_find(told) == told.end());
  CHECK(told.back() <= result.mesh.positions.size());
  CHECK(2 * told.back() > result.mesh.positions.size());
}

TEST_SUITE("slow") {
  TEST_CASE("the static method meshes the molecules of Table 1 and more in every model") {
    for (const char* file : {"5tmn_ligand.pdb", "9dna.pdb", "1grm_model1.pdb", "1crn.pdb",
                             "c60.xyz", "shell_hollow.xyzr", "two_balls.xyzr"}) {
      check_molecule(file);
    }
  }
  TEST_CASE("the static method certifies 600 nasty and 200 random ball sets") {
    support::for_seeds(600, [&](unsigned seed) { check_static(support::nasty_set(seed)); });
    support::for_seeds(200, [&](unsigned seed) { check_static(support::ball_set(seed)); });
  }
}
