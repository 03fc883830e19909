#include "skin/model.h"

#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::skin;

namespace {

constexpr Model all_models[] = {Model::Paper, Model::Sas, Model::Vdw, Model::SesLike};
constexpr double probe = 1.4;

Molecule carbon_and_oxygen() { return parse_molecule("0.1 0 -3.25 1.7\n1.2 0 0 1.52\n", "a.xyzr"); }

}  // namespace

TEST_CASE("a model is found again by its name") {
  for (const Model model : all_models) CHECK(parse_model(name_of(model)) == model);
  CHECK_FALSE(parse_model("SAS").has_value());
  CHECK_FALSE(parse_model("").has_value());
}

TEST_CASE("sas patches have the solvent-accessible radius and vdw patches the atom's") {
  for (const double radius : {1.2, 1.52, 1.7, 3.48}) {
    CAPTURE(radius);
    CHECK(patch_radius(weight(radius, Model::Sas, probe)) == doctest::Approx(radius + probe));
    CHECK(patch_radius(weight(radius, Model::Vdw, probe)) == doctest::Approx(radius));
    CHECK(weight(radius, Model::SesLike, probe) == weight(radius, Model::Sas, ses_like_offset));
  }
}

TEST_CASE("the paper's weight gives carbon a patch of 1.48 Angstrom") {
  CHECK(weight(1.7, Model::Paper, probe) == doctest::Approx(std::sqrt(2.0) * 3.1));
  CHECK(patch_radius(weight(1.7, Model::Paper, probe)) == doctest::Approx(1.48).epsilon(0.001));
}

TEST_CASE("the probe plays no part in the vdw model and does in the others") {
  CHECK(weight(1.7, Model::Vdw, 0) == weight(1.7, Model::Vdw, probe));
  CHECK(weight(1.7, Model::Sas, 0) < weight(1.7, Model::Sas, probe));
  CHECK(weight(1.7, Model::Paper, 0) < weight(1.7, Model::Paper, probe));
}

TEST_CASE("every atom becomes one weighted point at its place, in order") {
  const Molecule molecule = carbon_and_oxygen();
  for (const Model model : all_models) {
    const std::vector<WeightedPoint> points = weighted_points(molecule, model, probe);
    REQUIRE(points.size() == molecule.atoms.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(points[i].position == molecule.atoms[i].position);
      CHECK(points[i].weight == weight(molecule.atoms[i].radius, model, probe));
    }
  }
}

TEST_CASE("the balls written out are the balls read back") {
  const auto points = weighted_points(carbon_and_oxygen(), Model::Paper, probe);
  const Molecule balls = parse_molecule(xyzr_text(points), "balls.xyzr");
  REQUIRE(balls.atoms.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(balls.atoms[i].position == points[i].position);
    CHECK(balls.atoms[i].radius == patch_radius(points[i].weight));
  }
  CHECK(xyzr_text({{{0, 1.5, -2}, 8}}) == "0 1.5 -2 2\n");
}
