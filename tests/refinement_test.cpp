#include "refine/refinement.h"

#include "refine/mesh_operations.h"
#include "tests/support/refined_meshes.h"

using namespace morskin;
using namespace morskin::refine;
using namespace morskin::support;

namespace {

bool faces_outward(const Mesh& mesh, VertexId a, VertexId b, VertexId c) {
  const Vector n =
      (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).normalized();
  constexpr double upright = 0.5;
  return n.dot(mesh.at(a).normal) > upright && n.dot(mesh.at(b).normal) > upright &&
         n.dot(mesh.at(c).normal) > upright;
}

/// Flips random edges as long as both new triangles face outward; returns how many were flipped.
std::size_t spoil_by_flips(Mesh& mesh, Random& random, std::size_t tries) {
  std::size_t flipped = 0;
  SurfaceMesh& surface = mesh.surface;
  for (std::size_t i = 0; i < tries; ++i) {
    const HalfEdgeId h{random.below(3 * surface.triangle_count())};
    const HalfEdgeId g = surface.twin(h);
    const VertexId a = surface.origin(h), b = surface.target(h);
    const VertexId c = surface.apex(h), d = surface.apex(g);
    if (c == d || surface.has_edge(c, d) || !faces_outward(mesh, a, d, c) ||
        !faces_outward(mesh, b, c, d)) {
      continue;
    }
    surface.flip(h);
    ++flipped;
  }
  return flipped;
}

/// Puts new vertices into random triangles, mostly close to a corner.
std::size_t spoil_by_splits(const PreparedSkin& skin, Mesh& mesh, Random& random,
                            std::size_t count) {
  std::size_t made = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const TriangleId t{random.below(mesh.surface.triangle_count())};
    const auto [a, b, c] = mesh.surface.corners(t);
    const double s = random.between(0.05, 0.3);
    const auto x = skin.surface.project(
        (1 - 2 * s) * mesh.position(a) + s * mesh.position(b) + s * mesh.position(c),
        mesh.at(a).cell);
    if (!x) continue;
    mesh.surface.split(t, mesh.add_vertex(*x));
    ++made;
  }
  return made;
}

/// Whether the line through x along its normal crosses a triangle.
bool is_crossed(const std::array<Point, 3>& p, const SurfacePoint& x) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = (p[(k + 1) % 3] - p[k]).cross(x.position - p[k]).dot(x.normal);
    left += side > 0;
    right += side < 0;
  }
  return left == 3 || right == 3;
}

}  // namespace

TEST_CASE("points of the surface are near their own sheet's triangle and no other they lie over") {
  std::size_t own = 0, others = 0;
  for (const PreparedSkin& skin : small_skins()) {
    const Mesh mesh = refined_mesh(skin, {.C = 0.2});
    const auto at = [&](VertexId v) -> const SurfacePoint& { return mesh.at(v); };
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); t += 3) {
      const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
      const auto x = skin.surface.project(
          (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3, mesh.at(a).cell);
      REQUIRE(x.has_value());
      for (std::size_t other = 0; other < mesh.surface.triangle_count(); ++other) {
        const auto corners = mesh.surface.corners(TriangleId{other});
        const auto& [p, q, r] = corners;
        if (!is_crossed({mesh.position(p), mesh.position(q), mesh.position(r)}, *x)) continue;
        const bool is_own = (mesh.position(p) - x->position).norm() < x->length_scale;
        CHECK(is_near(at, corners, *x) == is_own);
        ++(is_own ? own : others);
      }
    }
  }
  CHECK(own > 1000);
  CHECK(others > 1000);
}

TEST_CASE("the coarsest triangles are nearer than their length scale to the surface over them") {
  for (const PreparedSkin& skin : small_skins()) {
    const Mesh mesh = refined_mesh(skin, {.C = 0.4, .Q = Sizing::quality_for(0.4)});
    const auto at = [&](VertexId v) -> const SurfacePoint& { return mesh.at(v); };
    Random random(7);
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto corners = mesh.surface.corners(TriangleId{t});
      const auto& [a, b, c] = corners;
      const double s = random.uniform(), u = random.between(0, 1 - s);
      const auto x = skin.surface.project(
          s * mesh.position(a) + u * mesh.position(b) + (1 - s - u) * mesh.position(c),
          mesh.at(a).cell);
      REQUIRE(x.has_value());
      CHECK(is_near(at, corners, *x));
    }
  }
}

TEST_CASE("refinement of a swept mesh leaves no breach of [L] or [U] and keeps the topology") {
  for_skins(10, [&](const PreparedSkin& skin) {
    Mesh mesh = swept_mesh(skin);
    const std::size_t components = geometry::components(mesh.surface).count;
    CHECK(components == skin.topology.skin_components());
    refine_mesh(skin, mesh);
    check_refined(skin, mesh);
  });
}

TEST_CASE("refining twice changes nothing the second time") {
  for (const PreparedSkin& skin : small_skins()) {
    Mesh mesh = refined_mesh(skin);
    const auto before = mesh.surface.triangle_list();
    const RefinementCounts counts = refine_mesh(skin, mesh);
    CHECK(counts.flip + counts.contract + counts.insert + counts.refused == 0);
    CHECK(mesh.surface.triangle_list() == before);
  }
}

TEST_CASE("no vertex lies in the surface ball of a triangle of a refined mesh") {
  for (const PreparedSkin& skin : small_skins()) {
    const Mesh mesh = refined_mesh(skin);
    CHECK(entered_balls(skin, mesh) == 0);
  }
}

TEST_CASE("random flips are undone: the restricted Delaunay triangulation is found again") {
  for_seeds<Random>(8, [&](unsigned seed, Random& random) {
    const PreparedSkin skin = small_skins()[seed % 4];
    Mesh mesh = refined_mesh(skin);
    REQUIRE(spoil_by_flips(mesh, random, 500) > 50);
    refine_mesh(skin, mesh);
    check_refined(skin, mesh);
    CHECK(entered_balls(skin, mesh) == 0);
  });
}

TEST_CASE("vertices put in too close to others are taken out again") {
  for_seeds<Random>(8, [&](unsigned seed, Random& random) {
    const PreparedSkin skin = small_skins()[seed % 4];
    Mesh mesh = refined_mesh(skin);
    REQUIRE(spoil_by_splits(skin, mesh, random, 100) > 50);
    CHECK(breaches(mesh).L > 0);
    const RefinementCounts counts = refine_mesh(skin, mesh);
    CHECK(counts.contract > 0);
    check_refined(skin, mesh);
    CHECK(entered_balls(skin, mesh) == 0);
  });
}

TEST_CASE("a mesh spoiled by splits and flips together is repaired") {
  for_seeds<Random>(20, [&](unsigned seed, Random& random) {
    const PreparedSkin skin = small_skins()[seed % 4];
    Mesh mesh = refined_mesh(skin);
    spoil_by_splits(skin, mesh, random, 150);
    spoil_by_flips(mesh, random, 600);
    refine_mesh(skin, mesh);
    check_refined(skin, mesh);
  });
}

TEST_CASE("the sphere of eight times four triangles, far too coarse, is refined to a good one") {
  const PreparedSkin skin = small_skins()[0];
  Mesh mesh = projected_mesh(skin.surface, sphere_mesh(Point::Zero(), 1, 1));
  refine_mesh(skin, mesh);
  check_refined(skin, mesh);
}

TEST_CASE(
    "two vertices close together in one triangle of a coarse mesh do not hang the refinement") {
  // While the only vertex that could go has neighbours of degree three, contraction is refused; the
  // flips tried on the way queued the same edge again, for ever.
  const PreparedSkin skin = small_skins()[0];
  Mesh mesh = projected_mesh(skin.surface, sphere_mesh(Point::Zero(), 1, 0));
  for (const double h : {0.06, 0.07}) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{7U});
    const Point inside =
        (1 - 2 * h) * mesh.position(a) + h * mesh.position(b) + h * mesh.position(c);
    const auto x = skin.surface.project(inside, geometry::CellId{0U});
    mesh.surface.split(TriangleId{7U}, mesh.add_vertex(*x));
  }
  refine_mesh(skin, mesh);
  check_refined(skin, mesh);
}

TEST_CASE("a mesh too coarse for its sizing is refined, one too fine is thinned") {
  const Sizing coarse{0.1, 1.65}, fine{0.06, 1.65};
  for (const WeightedPoints& points :
       {WeightedPoints{ball(0, 0, 0, 1)},
        WeightedPoints{ball(0, 0, 0, 1.2), ball(2, 0, 0, 1.5), ball(0, 2.5, 0, 1)}}) {
    const PreparedSkin skin = prepare_skin(points);
    Mesh mesh = refined_mesh(skin, coarse), other = refined_mesh(skin, fine);
    CHECK(refine_mesh(skin, mesh, fine).insert > 0);
    check_refined(skin, mesh, fine);
    CHECK(refine_mesh(skin, other, coarse).contract > 0);
    check_refined(skin, other, coarse);
  }
}
