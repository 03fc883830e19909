#include "refine/refinement.h"

#include <doctest/doctest.h>

#include <cmath>

#include "front/sweep.h"
#include "morse/make_guide.h"
#include "morse/protecting_spheres.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::refine;
using morskin::PreparedSkin;
using support::ball;

namespace {

/// What the sweep leaves for the refinement.
Mesh swept_mesh(const PreparedSkin& skin, const Sizing& sizing = {}) {
  const morse::Guide guide = morse::make_guide(
      skin.surface, skin.topology.skin_euler_characteristic(), {}, sizing.tangent_disk_share());
  Mesh mesh;
  front::Sweep sweep(skin.surface, guide, {.sizing = sizing}, mesh);
  sweep.run();
  REQUIRE(sweep.open_edges() == 0);
  return mesh;
}

Mesh refined_mesh(const PreparedSkin& skin, const Sizing& sizing = {}) {
  morskin::MeshingOptions options = support::with(sizing);
  options.has_safety_net = false;
  return support::skin_mesh(skin.surface, morskin::make_mesh(skin, options));
}

RefinementCounts refine_mesh(const PreparedSkin& skin, Mesh& mesh, const Sizing& sizing = {}) {
  Refinement refinement(skin.surface, sizing, mesh);
  refinement.run();
  return refinement.counts();
}

struct Breaches {
  std::size_t L = 0, U = 0;
  bool operator==(const Breaches&) const = default;
};
Breaches breaches(const Mesh& mesh, const Sizing& sizing = {}) {
  Breaches found;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    const std::array p{&mesh.at(a), &mesh.at(b), &mesh.at(c)};
    const double radius = circumcircle(p[0]->position, p[1]->position, p[2]->position).radius;
    const double rho = min_length_scale(p);
    found.U += !(sizing.triangle_ratio(radius, rho) < 1);
    for (std::size_t k = 0; k < 3; ++k) {
      found.L += !(sizing.edge_ratio(*p[k], *p[(k + 1) % 3]) > 1);
    }
  }
  return found;
}

/// Sound, of the skin's topology, every vertex with its point, no breach left.
void check_refined(const PreparedSkin& skin, const Mesh& mesh, const Sizing& sizing = {}) {
  CHECK(geometry::validate(mesh.surface).value_or("") == "");
  REQUIRE(mesh.points.size() == mesh.surface.vertex_count());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    REQUIRE(mesh.surface.outgoing(VertexId{v}).has_value());
  }
  CHECK(breaches(mesh, sizing) == Breaches{});
  CHECK(static_cast<long>(mesh.surface.vertex_count()) -
            static_cast<long>(mesh.surface.triangle_count() / 2) ==
        skin.topology.skin_euler_characteristic());
  CHECK(geometry::components(mesh.surface).count == skin.topology.skin_components());
}

/// A ball this shallowly entered counts as empty: the refinement's own share of its squared radius.
constexpr double min_intrusion = 1e-9;

std::size_t entered_balls(const PreparedSkin& skin, const Mesh& mesh) {
  std::size_t entered = 0;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    const SurfaceBall around =
        exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (VertexId{v} == a || VertexId{v} == b || VertexId{v} == c) continue;
      // Twice, since the flips compare with the smaller of two balls, which may round apart.
      if (around.intrusion(mesh.position(VertexId{v})) >
          2 * min_intrusion * around.squared_radius) {
        ++entered;
        break;
      }
    }
  }
  return entered;
}

std::vector<support::WeightedPoints> small_skins() {
  return {{ball(0, 0, 0, 1)},
          {ball(0, 0, 0, 1), ball(1.9, 0.2, 0.1, 1.2)},
          {ball(0, 0, 0, 1), ball(2, 0.1, 0.3, 0.9), ball(0.8, 1.6, 0, 0.8)},
          support::tetrahedron_balls(2.3)};
}

bool faces_outward(const Mesh& mesh, VertexId a, VertexId b, VertexId c) {
  const Vector n =
      (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).normalized();
  constexpr double upright = 0.5;
  return n.dot(mesh.at(a).normal) > upright && n.dot(mesh.at(b).normal) > upright &&
         n.dot(mesh.at(c).normal) > upright;
}

/// Flips random edges as long as both new triangles face outward; returns how many were flipped.
std::size_t spoil_by_flips(Mesh& mesh, support::Random& random, std::size_t tries) {
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
std::size_t spoil_by_splits(const PreparedSkin& skin, Mesh& mesh, support::Random& random,
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

}  // namespace

TEST_CASE("refinement of a swept mesh leaves no breach of [L] or [U] and keeps the topology") {
  for (unsigned seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    const auto skin = support::prepared(support::ball_set(seed));
    if (!skin) continue;
    Mesh mesh = swept_mesh(*skin);
    const std::size_t components = geometry::components(mesh.surface).count;
    CHECK(components == skin->topology.skin_components());
    refine_mesh(*skin, mesh);
    check_refined(*skin, mesh);
  }
}

namespace {

constexpr Sizing coarse{.C = 0.12, .Q = 1.65};

/// Every triangle too big for the default sizing.
Work all_big(const Mesh& mesh) {
  Work work;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) work.big.emplace_back(t);
  return work;
}

}  // namespace

TEST_CASE("operations in a subdomain change no triangle with a vertex outside") {
  for (const auto& points : small_skins()) {
    const PreparedSkin skin = morskin::prepare_skin(points);
    Mesh mesh = refined_mesh(skin, coarse);
    const std::size_t triangles = mesh.surface.triangle_count();
    geometry::Parts parts;
    for (const SurfacePoint& p : mesh.points) parts.push_back(p.position.x() > 0.3 ? 1 : 0);
    std::vector<SurfaceMesh::Room> rooms;
    for (int k = 0; k < 2000; ++k) rooms.push_back(mesh.surface.add_room());
    parts.resize(mesh.surface.vertex_count(), 0);
    geometry::Parts changing = parts;
    const SurfaceMesh before = mesh.surface;

    LocalOperations part(skin.surface, {}, mesh, all_big(mesh), {changing, 0}, rooms);
    part.insert_into_big_triangles(100000);
    CHECK(part.counts().insert > 10);
    CHECK(geometry::validate(mesh.surface).value_or("") == "");
    std::size_t changed = 0;
    for (std::size_t t = 0; t < triangles; ++t) {
      const auto corners = before.corners(TriangleId{t});
      if (corners == mesh.surface.corners(TriangleId{t})) continue;
      ++changed;
      for (const VertexId v : corners) CHECK(parts[v] == 0);
    }
    CHECK(changed > 10);

    LocalOperations whole(skin.surface, {}, mesh);
    whole.take_over(part);
    CHECK(whole.counts().insert == part.counts().insert);
    whole.flip_where_needed();
    whole.contract_short_edges();
    whole.insert_into_big_triangles(100000);
    whole.contract_short_edges();
    CHECK(whole.work().big.size() + whole.work().too_short.size() == 0);
    mesh.surface.compact();
    check_refined(skin, mesh);
    CHECK(entered_balls(skin, mesh) == 0);
  }
}

TEST_CASE("a subdomain without room leaves its work as it is") {
  const PreparedSkin skin = morskin::prepare_skin(small_skins()[2]);
  Mesh mesh = refined_mesh(skin, coarse);
  geometry::Parts parts(mesh.points.size(), 0);
  const auto before = mesh.surface.triangle_list();
  LocalOperations part(skin.surface, {}, mesh, all_big(mesh), {parts, 0});
  part.insert_into_big_triangles(100000);
  CHECK(part.counts().insert == 0);
  CHECK(part.work().big.size() > 10);
  CHECK(mesh.surface.triangle_list() == before);
}

TEST_CASE("refinement in two halves has one outcome for any number of threads") {
  for (const auto& points : small_skins()) {
    const PreparedSkin skin = morskin::prepare_skin(points);
    const Mesh rough = refined_mesh(skin, coarse);
    Mesh alone = rough;
    const RefinementCounts counts = refine_mesh(skin, alone);
    CHECK(counts.insert > 128);  // else no halves
    check_refined(skin, alone);
    for (const unsigned threads : {2U, 3U}) {
      Mesh together = rough;
      Refinement refinement(skin.surface, {}, together, geometry::Run(threads));
      refinement.run();
      CHECK(refinement.counts().flip == counts.flip);
      CHECK(refinement.counts().insert == counts.insert);
      CHECK(together.surface.triangle_list() == alone.surface.triangle_list());
      REQUIRE(together.points.size() == alone.points.size());
      for (std::size_t v = 0; v < alone.points.size(); ++v) {
        CHECK(together.position(VertexId{v}) == alone.position(VertexId{v}));
      }
    }
  }
}

TEST_CASE("refining twice changes nothing the second time") {
  for (const auto& points : small_skins()) {
    const PreparedSkin skin = morskin::prepare_skin(points);
    Mesh mesh = refined_mesh(skin);
    const auto before = mesh.surface.triangle_list();
    const RefinementCounts counts = refine_mesh(skin, mesh);
    CHECK(counts.flip + counts.contract + counts.insert + counts.refused == 0);
    CHECK(mesh.surface.triangle_list() == before);
  }
}

TEST_CASE("no vertex lies in the surface ball of a triangle of a refined mesh") {
  for (const auto& points : small_skins()) {
    const PreparedSkin skin = morskin::prepare_skin(points);
    const Mesh mesh = refined_mesh(skin);
    CHECK(entered_balls(skin, mesh) == 0);
  }
}

TEST_CASE("random flips are undone: the restricted Delaunay triangulation is found again") {
  for (unsigned seed = 0; seed < 8; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const PreparedSkin skin = morskin::prepare_skin(small_skins()[seed % 4]);
    Mesh mesh = refined_mesh(skin);
    REQUIRE(spoil_by_flips(mesh, random, 500) > 50);
    refine_mesh(skin, mesh);
    check_refined(skin, mesh);
    CHECK(entered_balls(skin, mesh) == 0);
  }
}

TEST_CASE("vertices put in too close to others are taken out again") {
  for (unsigned seed = 0; seed < 8; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const PreparedSkin skin = morskin::prepare_skin(small_skins()[seed % 4]);
    Mesh mesh = refined_mesh(skin);
    REQUIRE(spoil_by_splits(skin, mesh, random, 100) > 50);
    CHECK(breaches(mesh).L > 0);
    const RefinementCounts counts = refine_mesh(skin, mesh);
    CHECK(counts.contract > 0);
    check_refined(skin, mesh);
    CHECK(entered_balls(skin, mesh) == 0);
  }
}

TEST_CASE("a mesh spoiled by splits and flips together is repaired") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const PreparedSkin skin = morskin::prepare_skin(small_skins()[seed % 4]);
    Mesh mesh = refined_mesh(skin);
    spoil_by_splits(skin, mesh, random, 150);
    spoil_by_flips(mesh, random, 600);
    refine_mesh(skin, mesh);
    check_refined(skin, mesh);
  }
}

TEST_CASE("the sphere of eight times four triangles, far too coarse, is refined to a good one") {
  const PreparedSkin skin = morskin::prepare_skin(support::WeightedPoints{ball(0, 0, 0, 1)});
  const auto sphere = support::sphere_mesh(Point::Zero(), 1, 1);
  Mesh mesh;
  mesh.surface = geometry::closed_mesh(sphere.positions.size(), sphere.triangles).mesh;
  for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
    mesh.points[VertexId{v}] = *skin.surface.project(sphere.positions[v], geometry::CellId{0U});
  }
  refine_mesh(skin, mesh);
  check_refined(skin, mesh);
}

TEST_CASE("a surface ball is centred on the skin and passes through its triangle's corners") {
  for (const auto& points : small_skins()) {
    const PreparedSkin skin = morskin::prepare_skin(points);
    const Mesh mesh = refined_mesh(skin);
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
      const SurfaceBall around =
          exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
      const double rho = mesh.at(a).length_scale;
      // What rounding leaves of a length of the order of rho, and twice G over its slope.
      const double off = 1e-10 * rho;
      CHECK(std::abs(skin.surface.value(around.centre, mesh.at(a).cell)) <= 2 * rho * off);
      for (const VertexId v : {a, b, c}) {
        CHECK(std::abs(around.intrusion(mesh.position(v))) <= 2 * off * rho);
      }
    }
  }
}

TEST_CASE("a surface ball found to rounding is as deep as its bounds say, and they mostly decide") {
  for (const auto& points : small_skins()) {
    const PreparedSkin skin = morskin::prepare_skin(points);
    const Mesh mesh = swept_mesh(skin);  // worse triangles than a refined one has
    std::size_t asked = 0, decided = 0;
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
      const SurfaceBall exact =
          exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
      if (!exact.is_exact) continue;
      LazySurfaceBall ball(skin.surface, {&mesh.at(a), &mesh.at(b), &mesh.at(c)},
                           circumcircle(mesh.position(a), mesh.position(b), mesh.position(c)));
      const double rounding = 1e-8 * exact.squared_radius;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
        const Point& p = mesh.position(mesh.surface.apex(mesh.surface.twin(h)));
        const double depth = exact.intrusion(p);
        const Depth bounds = ball.depth(p), intrusion = ball.intrusion(p);
        CHECK(bounds.min <= depth + rounding);
        CHECK(bounds.max >= depth - rounding);
        if (std::abs(depth) > rounding) CHECK((intrusion.max > 0) == (depth > 0));
        ++asked;
        decided += bounds.max <= 0 || bounds.min > 0;
      }
    }
    CHECK(10 * decided > 9 * asked);
  }
}

TEST_CASE(
    "two vertices close together in one triangle of a coarse mesh do not hang the refinement") {
  // While the only vertex that could go has neighbours of degree three, contraction is refused; the
  // flips tried on the way queued the same edge again, for ever.
  const PreparedSkin skin = morskin::prepare_skin(support::WeightedPoints{ball(0, 0, 0, 1)});
  const auto s = support::sphere_mesh(Point::Zero(), 1, 0);
  Mesh mesh;
  mesh.surface = geometry::closed_mesh(6, s.triangles).mesh;
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    mesh.points[VertexId{v}] = *skin.surface.project(s.positions[v], geometry::CellId{0U});
  }
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
  for (const support::WeightedPoints& points :
       {support::WeightedPoints{ball(0, 0, 0, 1)},
        support::WeightedPoints{ball(0, 0, 0, 1.2), ball(2, 0, 0, 1.5), ball(0, 2.5, 0, 1)}}) {
    const PreparedSkin skin = morskin::prepare_skin(points);
    Mesh mesh = refined_mesh(skin, coarse), other = refined_mesh(skin, fine);
    CHECK(refine_mesh(skin, mesh, fine).insert > 0);
    check_refined(skin, mesh, fine);
    CHECK(refine_mesh(skin, other, coarse).contract > 0);
    check_refined(skin, other, coarse);
  }
}
