#include "refine/smoothing.h"

#include "certify/restricted_delaunay.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::certify;
using namespace morskin::refine;
using namespace morskin::support;

namespace {

constexpr double goal_deg = 30;

/// A mesh of the sweep, refined and not smoothed.
Mesh rough_mesh(const PreparedSkin& skin) {
  return skin_mesh(skin.surface,
                   make_mesh(skin, {.sizing = {}, .angle_goal_deg = 0, .has_safety_net = false}));
}

Certificate certificate(const PreparedSkin& skin, const Mesh& mesh) {
  return certify::certify(indexed_mesh(mesh), skin.surface, skin.topology);
}

std::size_t triangles_below(const Mesh& mesh, double angle_deg) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    count +=
        angle_range(mesh.position(a), mesh.position(b), mesh.position(c)).smallest_deg < angle_deg;
  }
  return count;
}

std::vector<PreparedSkin> skins() {
  std::vector<PreparedSkin> result;
  for_molecules({"cube8.xyzr", "benzene.pdb", "c60.xyz", "5tmn_ligand.pdb"},
                [&](const auto& balls) { result.push_back(prepare_skin(balls)); });
  for_skins(15, [&](const PreparedSkin& skin) { result.push_back(skin); });
  return result;
}

}  // namespace

TEST_CASE("smoothing leaves no angle below 30 degrees, and the mesh certified") {
  std::size_t moved = 0;
  for (const PreparedSkin& skin : skins()) {
    Mesh mesh = rough_mesh(skin);
    const SmoothingCounts counts = smooth(skin.surface, {}, mesh, goal_deg);
    moved += counts.moved;
    CHECK(counts.left.empty());
    const Certificate c = certificate(skin, mesh);
    CHECK(c.reason == "");
    CHECK(c.min_angle_deg > goal_deg - 1e-9);
  }
  CHECK(moved > 20);
}

TEST_CASE("smoothing keeps every triangle's corners and lets no vertex into a surface ball") {
  for (const PreparedSkin& skin : skins()) {
    Mesh mesh = rough_mesh(skin);
    const auto before = mesh.surface.triangle_list();
    smooth(skin.surface, {}, mesh, goal_deg);
    CHECK(mesh.surface.triangle_list() == before);
    CHECK(restricted_delaunay(indexed_mesh(mesh), skin.surface, mesh.points).violations == 0);
  }
}

TEST_CASE("the counts before and after are those of all triangles one by one") {
  for (const PreparedSkin& skin : skins()) {
    Mesh mesh = rough_mesh(skin);
    constexpr double high_deg = 36;  // so that some are left
    const std::size_t before = triangles_below(mesh, high_deg);
    const SmoothingCounts counts = smooth(skin.surface, {}, mesh, high_deg);
    CHECK(counts.below == before);
    CHECK(counts.left.size() == triangles_below(mesh, high_deg));
  }
}

TEST_CASE("a goal that cannot be met raises the smallest angle all the same and breaks nothing") {
  const PreparedSkin skin = prepare_skin({ball(0, 0, 0, 1), ball(1.9, 0.2, 0.1, 1.2)});
  Mesh mesh = rough_mesh(skin);
  const double before = certificate(skin, mesh).min_angle_deg;
  const SmoothingCounts counts = smooth(skin.surface, {}, mesh, 60);
  CHECK(!counts.left.empty());
  const Certificate after = certificate(skin, mesh);
  CHECK(after.certified);
  CHECK(after.min_angle_deg > before);
}

TEST_CASE("a mesh without an angle below the goal is left as it is, and so is any for the goal 0") {
  const PreparedSkin skin = prepare_skin({ball(0, 0, 0, 1)});
  Mesh mesh = rough_mesh(skin);
  smooth(skin.surface, {}, mesh, goal_deg);
  const geometry::IndexedMesh once = indexed_mesh(mesh);
  CHECK(smooth(skin.surface, {}, mesh, goal_deg).moved == 0);
  CHECK(smooth(skin.surface, {}, mesh, 0).below == 0);
  CHECK(indexed_mesh(mesh).positions == once.positions);
}

TEST_CASE("smoothing is the same with any number of threads") {
  const PreparedSkin skin = prepare_skin(molecule("5tmn_ligand.pdb", skin::Model::Paper));
  Mesh first = rough_mesh(skin);
  Mesh second = first;
  smooth(skin.surface, {}, first, goal_deg, geometry::Run(1));
  smooth(skin.surface, {}, second, goal_deg, geometry::Run(3));
  CHECK(indexed_mesh(first).positions == indexed_mesh(second).positions);
}

TEST_CASE("smoothing in many small boxes keeps every law, and is the same in any order of them") {
  constexpr std::size_t least_to_each = 50;
  std::size_t moved = 0;
  for (const PreparedSkin& skin : skins()) {
    Mesh mesh = rough_mesh(skin);
    Mesh other = mesh;
    const auto before = mesh.surface.triangle_list();
    const SmoothingCounts counts =
        smooth(skin.surface, {}, mesh, goal_deg, geometry::Run(1), least_to_each);
    moved += counts.moved;
    CHECK(counts.left.empty());
    CHECK(mesh.surface.triangle_list() == before);
    CHECK(certificate(skin, mesh).reason == "");
    CHECK(restricted_delaunay(indexed_mesh(mesh), skin.surface, mesh.points).violations == 0);
    CHECK(smooth(skin.surface, {}, other, goal_deg, geometry::Run(4), least_to_each).moved ==
          counts.moved);
    CHECK(indexed_mesh(mesh).positions == indexed_mesh(other).positions);
  }
  CHECK(moved > 20);
}
