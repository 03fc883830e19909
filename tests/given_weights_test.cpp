// Files of weights (XYZW): what is written is what comes back.

#include <bit>

#include "geometry/error.h"
#include "geometry/exact_range.h"
#include "skin/model.h"
#include "skin/molecule_files.h"
#include "tests/support/molecule_texts.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::skin;

namespace {

bool is_same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::vector<WeightedPoint> read_back(const std::string& text, const std::string& name) {
  const Molecule molecule = parse_molecule(text, name);
  CHECK(molecule.weights.size() == molecule.atoms.size());
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    CHECK(molecule.atoms[i].radius == patch_radius(molecule.weights[i]));
  }
  return weighted_points(molecule, Model::Given, 1.4);
}

/// Under the name, gzipped, and by the first line alone.
void check_round_trip(const std::vector<WeightedPoint>& points) {
  const std::string text = xyzw_text(points);
  for (const auto& [bytes, name] :
       {std::pair(text, "a.xyzw"), std::pair(support::gzipped(text), "a.XYZW.gz"),
        std::pair(text, "-")}) {
    const std::vector<WeightedPoint> again = read_back(bytes, name);
    REQUIRE(again.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(is_same(again[i].weight, points[i].weight));
      for (int k = 0; k < 3; ++k) CHECK(is_same(again[i].position[k], points[i].position[k]));
    }
  }
}

}  // namespace

TEST_CASE("the weights of every bundled molecule come back bit for bit, in every model it has") {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator("bench/molecules")) {
    if (!molecule_format_of(entry.path())) continue;
    ++files;
    const Molecule molecule = read_molecule(entry.path());
    const std::vector<Model> models = molecule.weights.empty()
                                          ? std::vector{Model::Paper, Model::Sas, Model::Vdw}
                                          : std::vector{Model::Given};
    for (const Model model : models) check_round_trip(weighted_points(molecule, model, 1.4));
  }
  CHECK(files > 5);
}

TEST_CASE("any 1,000 weights come back bit for bit") {
  std::mt19937_64 random(1);
  std::vector<WeightedPoint> points(1000);
  const auto number = [&](int lowest, int highest) {
    const int exponent =
        lowest + static_cast<int>(random() % static_cast<unsigned>(highest - lowest));
    return std::ldexp(1 + std::ldexp(static_cast<double>(random() >> 12), -52), exponent);
  };
  for (WeightedPoint& p : points) {
    for (double& x : p.position) x = (random() % 2 == 0 ? 1 : -1) * number(-68, 19);
    p.weight = number(-188, 30);
    CHECK(is_exact_weight(p.weight));
  }
  check_round_trip(points);
}

TEST_CASE("weights are never taken for radii, nor radii for weights") {
  CHECK_THROWS_WITH_AS(parse_molecule("# x y z w\n0 0 0 1\n", "a.xyzr"),
                       doctest::Contains("weights, not radii"), UnreadableInput);
  CHECK(parse_molecule("0 0 0 1\n", "a.xyzr").weights.empty());
  CHECK(parse_molecule("# x y z r\n0 0 0 1\n", "-").weights.empty());
  CHECK(parse_molecule("# of gramicidin\n# x y z w\n0 0 0 1\n", "-").weights.size() == 1);
}

TEST_CASE("a weight that is no weight of a ball is turned down with its line") {
  for (const char* weight : {"0", "-1", "nan", "inf", "1.1e9"}) {
    CHECK_THROWS_WITH_AS(parse_molecule("0 0 0 1\n0 0 0 " + std::string(weight), "a.xyzw"),
                         doctest::Contains("a.xyzw:2: ball (line 2) has a weight"), RefusedInput);
  }
  CHECK_THROWS_WITH_AS(parse_molecule("0 0 1\n", "a.xyzw"),
                       doctest::Contains("a.xyzw:1: expected x y z w"), UnreadableInput);
}
