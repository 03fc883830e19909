#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "morskin/pipeline.h"
#include "tests/support/meshes.h"

using namespace morskin;
using support::WeightedPoints;

namespace {

constexpr std::array small_molecules{"5tmn_ligand.pdb", "caffeine.xyz",     "benzene.pdb",
                                     "c60.xyz",         "cube8.xyzr",       "ring12.xyzr",
                                     "two_balls.xyzr",  "shell_hollow.xyzr"};
constexpr std::array all_models{skin::Model::Paper, skin::Model::Sas, skin::Model::Vdw};

/// What every result must be, whatever went in.
void check_result(const MeshResult& result, const certify::Sizing& sizing = {}) {
  const certify::Certificate& certificate = result.certificate;
  CHECK(certificate.reason == "");
  CHECK(certificate.certified);
  CHECK(certificate.is_homeomorphic);
  CHECK(certificate.covering_degree_ok);
  CHECK(certificate.min_angle_deg > sizing.angle_bound_deg());
  CHECK(certificate.worst_L > 1);
  CHECK(certificate.worst_U < 1);
  const long chi = support::euler_characteristic(result.critical_points);
  CHECK(certificate.euler_characteristic == chi);
  CHECK(chi == certificate.expected_euler_characteristic);
  CHECK(certificate.components == certificate.expected_components);
  CHECK(result.open_edges == 0);
  // A second look at the counts, by other code than the certificate's.
  const auto built = geometry::closed_mesh(result.mesh.positions.size(), result.mesh.triangles);
  REQUIRE(built.defect.value_or("") == "");
  CHECK(geometry::validate(built.mesh).value_or("") == "");
  CHECK(geometry::components(built.mesh).count == certificate.expected_components);
  CHECK(static_cast<long>(result.mesh.positions.size()) -
            static_cast<long>(result.mesh.triangles.size() / 2) ==
        chi);
}

bool are_same_bytes(const MeshResult& a, const MeshResult& b) {
  if (a.mesh.triangles != b.mesh.triangles || a.mesh.positions.size() != b.mesh.positions.size()) {
    return false;
  }
  for (std::size_t v = 0; v < a.mesh.positions.size(); ++v) {
    if (a.mesh.positions[v] != b.mesh.positions[v]) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("small molecules are certified in all three models, every angle above 21.54 degrees") {
  for (const char* const name : small_molecules) {
    CAPTURE(std::string(name));
    for (const skin::Model model : all_models) {
      CAPTURE(std::string(skin::name_of(model)));
      const MeshResult result = support::meshed(support::molecule(name, model));
      check_result(result);
      CHECK(result.certificate.min_angle_deg > 21.54);
    }
  }
}

TEST_CASE("random ball sets are certified or refused as singular") {
  support::for_skins(25, [&](const PreparedSkin& skin) { check_result(morskin::make_mesh(skin)); });
}

TEST_CASE("the same run twice gives the same bytes") {
  const WeightedPoints points = support::molecule("5tmn_ligand.pdb", skin::Model::Vdw);
  const MeshingOptions options = support::uncertified();
  const MeshResult first = support::meshed(points, options);
  support::meshed(support::molecule("caffeine.xyz", skin::Model::Vdw), options);
  CHECK(are_same_bytes(first, support::meshed(points, options)));
  CHECK(are_same_bytes(first, morskin::make_mesh(morskin::prepare_skin(points))));
}

TEST_CASE("shuffled atoms give the same surface: its Euler characteristic, and its area to 0.1 %") {
  constexpr double same_area = 1e-3;
  const auto check = [&](const WeightedPoints& points) {
    const MeshResult plain = support::meshed(points);
    const MeshResult other = support::meshed(support::shuffled(points, 1));
    check_result(other);
    CHECK(other.certificate.euler_characteristic == plain.certificate.euler_characteristic);
    CHECK(std::abs(other.certificate.area - plain.certificate.area) <
          same_area * plain.certificate.area);
    CHECK(std::abs(other.certificate.volume - plain.certificate.volume) <
          same_area * plain.certificate.volume);
  };
  check(support::molecule("caffeine.xyz", skin::Model::Sas));
  check(support::molecule("cube8.xyzr", skin::Model::Paper));
  for (unsigned seed = 200; seed < 203; ++seed) {
    CAPTURE(seed);
    check(support::ball_set(seed));
  }
}

TEST_CASE("the mesh of one ball has nearly the ball's area and volume, from inside") {
  for (const double r : {0.5, 1.0, 3.0}) {
    CAPTURE(r);
    const MeshResult result = support::meshed(WeightedPoints{support::ball(1, 2, 3, r)});
    check_result(result);
    const double area = 4 * M_PI * r * r, volume = area * r / 3;
    // A triangle of circumradius R lies within R^2 / rho of the sphere it is inscribed in: 1e.
    constexpr double deepest = 0.132 * 0.132;
    CHECK(result.certificate.area < area);
    CHECK(result.certificate.area > area * (1 - 2 * deepest));
    CHECK(result.certificate.volume < volume);
    CHECK(result.certificate.volume > volume * (1 - 3 * deepest));
  }
}

TEST_CASE("every direction gives a certified mesh of the same surface") {
  const PreparedSkin skin =
      morskin::prepare_skin(support::molecule("caffeine.xyz", skin::Model::Vdw));
  support::Random random(1);
  const double area = morskin::make_mesh(skin).certificate.area;
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i);
    MeshingOptions options;
    options.function = morse::MorseFunction::height(3 * random.direction());  // of any length
    const MeshResult result = morskin::make_mesh(skin, options);
    check_result(result);
    CHECK(result.function.direction == options.function->direction);
    CHECK(std::abs(result.certificate.area - area) < 1e-3 * area);
  }
}

TEST_CASE(
    "every squared distance gives a certified mesh of the same surface, with one front or two") {
  const PreparedSkin skin =
      morskin::prepare_skin(support::molecule("caffeine.xyz", skin::Model::Vdw));
  support::Random random(2);
  const double area = morskin::make_mesh(skin).certificate.area;
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i);
    MeshingOptions options;
    options.function =
        morse::MorseFunction::squared_distance(random.between(0, 12) * random.direction());
    options.fronts = 1 + i % 2;
    const MeshResult result = morskin::make_mesh(skin, options);
    check_result(result);
    CHECK(std::abs(result.certificate.area - area) < 1e-3 * area);
  }
}

TEST_CASE("a degenerate direction that the user gives is refused, the default finds its way") {
  for (const skin::Model model : all_models) {
    const PreparedSkin skin = morskin::prepare_skin(support::molecule("cube8.xyzr", model));
    CHECK_THROWS_AS(morskin::make_mesh(skin, support::along(geometry::Vector::UnitY())),
                    morse::DegenerateFunction);
    check_result(morskin::make_mesh(skin));
  }
}

TEST_CASE("other constants give meshes that keep their own bounds, finer for smaller C") {
  const PreparedSkin skin = morskin::prepare_skin(
      {support::ball(0, 0, 0, 1), support::ball(1.7, 0, 0, 1.2), support::ball(0.8, 1.5, 0, 0.8)});
  std::size_t finer = 0;
  for (const certify::Sizing sizing : {certify::Sizing{0.05, 1.65}, certify::Sizing{0.08, 1.65},
                                       certify::Sizing{0.08, 1.7}, certify::Sizing{0.1, 1.65}}) {
    CAPTURE(sizing.C);
    CAPTURE(sizing.Q);
    const MeshResult result = morskin::make_mesh(skin, support::with(sizing));
    check_result(result, sizing);
    if (sizing.Q == 1.65) {
      CHECK((finer == 0 || result.mesh.triangles.size() < finer));
      finer = result.mesh.triangles.size();
    }
  }
}

TEST_CASE(
    "operations and stages are counted: one bowl for each surviving minimum, progress from stage "
    "to stage") {
  const PreparedSkin skin =
      morskin::prepare_skin(support::molecule("ring12.xyzr", skin::Model::Vdw));
  std::vector<std::string> stages;
  const morskin::Run run(1, [&](std::string_view stage, double share) {
    CHECK((share == geometry::unknown_share || (share >= 0 && share <= 1)));
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
  });
  MeshingOptions options;
  options.fronts = 1;
  const MeshResult result = morskin::make_mesh(skin, options, run);
  CHECK(result.operations.creation == result.surviving_points[0]);
  CHECK(result.operations.bridge <= result.surviving_points[1]);
  CHECK(result.operations.seal <= result.surviving_points[2]);
  CHECK(stages.front() == "critical points");
  CHECK(stages.back() == "certify");
}

TEST_CASE("input without a surface is refused") {
  CHECK_THROWS_AS(support::meshed(WeightedPoints{}), geometry::RefusedInput);
  CHECK_THROWS_AS(support::meshed(WeightedPoints{{{0, 0, 0}, 0.0}}), geometry::RefusedInput);
  CHECK_THROWS_AS(support::meshed(WeightedPoints{{{0, 0, 0}, 9}, {{0, 7, 0}, 16}}),
                  skin::SingularSkin);
}

TEST_CASE("doubling all lengths doubles every coordinate exactly") {
  for (unsigned seed = 100; seed < 110; ++seed) {  // 104 once hung the refinement
    CAPTURE(seed);
    const support::WeightedPoints points = support::ball_set(seed);
    const MeshResult a = support::meshed(points, support::uncertified());
    const MeshResult b = support::meshed(support::doubled(points), support::uncertified());
    REQUIRE(a.mesh.triangles == b.mesh.triangles);
    for (std::size_t v = 0; v < a.mesh.positions.size(); ++v) {
      REQUIRE(2 * a.mesh.positions[v] == b.mesh.positions[v]);
    }
  }
}

TEST_CASE(
    "a fine mesh is certified: the ball kept free about a vertex shrinks with the triangles") {
  MeshingOptions options;
  options.sizing.C = 0.02;
  const MeshResult result =
      support::meshed(support::WeightedPoints{{geometry::Point(0, 0, 0), 2}}, options);
  CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
}
