#include "refine/angle_refinement.h"

#include <array>

#include "certify/restricted_delaunay.h"
#include "morskin/method.h"
#include "morskin/pipeline_parts.h"
#include "refine/angle_improvement.h"
#include "refine/smoothing.h"
#include "tests/support/meshes.h"
#include "tests/support/molecules.h"

using namespace morskin;
using namespace morskin::certify;
using namespace morskin::refine;
using namespace morskin::support;

namespace {

struct Case {
  PreparedSkin skin;
  Sizing sizing;
};

/// Small molecules and random balls, fine and coarse.
template <class Check>
void for_cases(const Check& check) {
  for (const double C : {0.08, 0.2, 0.3, 0.4}) {
    CAPTURE(C);
    const Sizing sizing{.C = C, .Q = Sizing::quality_for(C)};
    for_molecules({"benzene.pdb", "5tmn_ligand.pdb"},
                  [&](const auto& balls) { check(prepare_skin(balls), sizing); });
    for_skins(8, [&](const PreparedSkin& skin) { check(skin, sizing); });
  }
}

/// A mesh by a method, refined, its angles as they came.
Mesh rough_mesh(const PreparedSkin& skin, const Sizing& sizing, Method method = Method::Sweep) {
  const MeshingOptions options{.sizing = sizing, .angle_goal_deg = 0, .method = method};
  return skin_mesh(skin.surface, make_mesh(skin, options));
}

double smallest_angle(const Mesh& mesh) {
  double least = 60;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    least = std::min(
        least, angle_range(mesh.position(a), mesh.position(b), mesh.position(c)).smallest_deg);
  }
  return least;
}

double shortest_edge(const Mesh& mesh) {
  double least = 1e300;
  for (std::size_t h = 0; h < 3 * mesh.surface.triangle_count(); ++h) {
    const HalfEdgeId e{h};
    least = std::min(
        least,
        (mesh.position(mesh.surface.origin(e)) - mesh.position(mesh.surface.target(e))).norm());
  }
  return least;
}

Certificate certificate(const PreparedSkin& skin, const Mesh& mesh, const Sizing& sizing) {
  return certify::certify(indexed_mesh(mesh), skin.surface, skin.topology, sizing);
}

}  // namespace

/// Refines rough meshes by a method, in space what that leaves.
/// @return of how many meshes something was left, of so many
std::array<int, 2> check_refinement(Method method) {
  std::array<int, 2> left_of{0, 0};
  for_cases([&](const PreparedSkin& skin, const Sizing& sizing) {
    Mesh mesh = rough_mesh(skin, sizing, method);
    const double before = smallest_angle(mesh), shortest = shortest_edge(mesh);
    const AngleRefinementCounts counts = refine_angles(skin.surface, sizing, mesh, 30);
    CHECK((counts.inserted > 0 || !counts.left.empty()) == (before < 30));
    ++left_of[1];
    if (!counts.left.empty()) {
      ++left_of[0];
      auto refined = refine_angles_in_space(skin, mesh, {.sizing = sizing}, 30, geometry::Run(1));
      REQUIRE(refined);
      mesh = std::move(*refined);
    }
    CHECK(smallest_angle(mesh) >= 30 - 1e-9);
    CHECK(shortest_edge(mesh) >= (1 - 1e-9) * shortest);
    const Certificate c = certificate(skin, mesh, sizing);
    CHECK(c.is_homeomorphic);
    CHECK(c.violations_U == 0);
    // Of coarser triangles not every edge that a ball asks to flip can be flipped.
    if (!counts.left.empty() || sizing.is_coarser_than_laid()) return;
    CHECK(restricted_delaunay(indexed_mesh(mesh), skin.surface, mesh.points).violations == 0);
  });
  return left_of;
}

TEST_CASE("refinement leaves no angle below 30 degrees and no edge shorter, from what is swept") {
  const auto [left, meshes] = check_refinement(Method::Sweep);
  CHECK(20 * left < meshes);
}

TEST_CASE("what refinement leaves of a mesh by the static method, refinement in space does not") {
  const auto [left, meshes] = check_refinement(Method::Static);
  CHECK(left > 0);
}

TEST_CASE("refinement in space does the same") {
  for_cases([](const PreparedSkin& skin, const Sizing& sizing) {
    const Mesh mesh = rough_mesh(skin, sizing);
    std::string stage;
    const geometry::Run run(1, [&](std::string_view name, double) { stage = name; });
    const auto refined = refine_angles_in_space(skin, mesh, {.sizing = sizing}, 30, run);
    REQUIRE(refined);
    CHECK(stage.starts_with("refine angles in space"));
    CHECK(smallest_angle(*refined) >= 30 - 1e-9);
    CHECK(shortest_edge(*refined) >= (1 - 1e-9) * shortest_edge(mesh));
    const Certificate c = certificate(skin, *refined, sizing);
    CHECK(c.is_homeomorphic);
    CHECK(c.violations_U == 0);
  });
}

TEST_CASE("what an insertion has brought to the goal is not counted as left below") {
  const PreparedSkin skin = prepare_skin(molecule("5tmn_ligand.pdb", skin::Model::Paper));
  MethodResult made;
  made.mesh = rough_mesh(skin, {});
  // By [L] of so large a C no edge is long enough, so nothing moves or goes before the last step.
  const Sizing coarse{.C = 0.4, .Q = Sizing::quality_for(0.4)};
  raise_angles(skin.surface, {.sizing = coarse}, made, geometry::Run(1));
  CHECK(made.improvement.changed == 0);
  CHECK(made.angles.inserted > 0);
  CHECK(smallest_angle(made.mesh) >= 30);
  CHECK(made.below_goal() == 0);
}

TEST_CASE("improvement leaves fewer angles below the goal, and a certified mesh") {
  std::size_t before = 0, left = 0;
  for_cases([&](const PreparedSkin& skin, const Sizing& sizing) {
    constexpr double goal_deg = 38;
    Mesh mesh = rough_mesh(skin, sizing);
    const std::vector<TriangleId> below = smooth(skin.surface, sizing, mesh, goal_deg).left;
    const std::size_t vertices = mesh.surface.vertex_count();
    const AngleImprovementCounts counts =
        improve_angles(skin.surface, sizing, mesh, goal_deg, below);
    CHECK(counts.left <= below.size());
    // Each vertex that goes or comes changes their number by one.
    const std::size_t now = mesh.surface.vertex_count();
    CHECK(counts.changed >= std::max(vertices, now) - std::min(vertices, now));
    CHECK((counts.changed + vertices + now) % 2 == 0);
    for (std::size_t v = 0; v < mesh.surface.vertex_count(); ++v) {
      CHECK(mesh.surface.outgoing(VertexId{v}));  // no trial leaves an empty slot
    }
    Mesh copy = mesh;
    CHECK(counts.left == smooth(skin.surface, sizing, copy, goal_deg).below);
    before += below.size();
    left += counts.left;
    CHECK(certificate(skin, mesh, sizing).reason == "");
    CHECK(restricted_delaunay(indexed_mesh(mesh), skin.surface, mesh.points).violations == 0);
  });
  CHECK(before > 50);
  CHECK(left < before / 4);
}
