#include "certify/restricted_delaunay.h"

#include "tests/support/good_mesh.h"

using namespace morskin;
using namespace morskin::support;
using geometry::IndexedMesh;
using geometry::Point;

namespace {

/// The count that the certificate makes.
std::size_t local_violations(const Good& good, const IndexedMesh& mesh) {
  const auto vertices = certify::locate_with_bounds(mesh, good.skin.surface);
  const certify::LocatedMesh on{mesh, vertices, good.skin.surface};
  certify::DelaunayFilter sure(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto points = on.corners(mesh.triangles[t]);
    const surface::Corners p = points;
    sure.note(geometry::TriangleId{t}, p, certify::TriangleSides(p),
              good.skin.surface.residual_bound(p[0]->length_scale));
  }
  const auto glued = geometry::closed_triangles(mesh.positions.size(), mesh.triangles);
  return certify::local_delaunay_violations(on, glued.mesh, sure, 3);
}

/// Whether a triangle's surface ball counts: found to rounding, of one smaller than its length
/// scale.
bool counts(const certify::SurfaceBall& ball,
            const std::array<const surface::SurfacePoint*, 3>& p) {
  const double radius =
      certify::circumcircle(p[0]->position, p[1]->position, p[2]->position).radius;
  return ball.is_exact && radius < surface::min_length_scale(p);
}

}  // namespace

TEST_CASE("restricted Delaunay violations are those that asking all vertices finds") {
  std::size_t seen = 0;
  for_seeds<Random>(40, [&](unsigned seed, Random& random) {
    const auto points = ball_set(seed);
    if (points.size() > 8 || !prepared(points)) return;
    const Good good(points);
    // Flipped edges and displaced vertices make violations, also far from the triangles flipped.
    auto mesh = geometry::closed_mesh(good.mesh.positions.size(), good.mesh.triangles).mesh;
    for (int flips = 0; flips < 30; ++flips) {
      const geometry::HalfEdgeId h{random.below(3 * mesh.triangle_count())};
      const auto c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
      if (c != d && !mesh.has_edge(c, d)) mesh.flip(h);
    }
    const IndexedMesh bad{good.mesh.positions, mesh.triangle_list()};
    const auto located = certify::locate_vertices(bad, good.skin.surface);
    std::size_t expected = 0;
    for (const auto& t : bad.triangles) {
      const auto ball = certify::exact_surface_ball(good.skin.surface, located[t[0]],
                                                    bad.positions[t[1]], bad.positions[t[2]]);
      if (!counts(ball, {&located[t[0]], &located[t[1]], &located[t[2]]})) continue;
      expected += std::ranges::any_of(bad.positions, [&](const Point& p) {
        return ball.intrusion(p) > 1e-8 * ball.squared_radius;
      });
    }
    const certify::RestrictedDelaunay found = good.delaunay(bad);
    CHECK(found.violations == expected);
    CHECK(found.violations > 0);
    CHECK(found.deepest[0].depth > 0);
    CHECK(good.delaunay(bad, 3).violations == expected);
    CHECK(good.delaunay(bad, 3).deepest[0].triangle == found.deepest[0].triangle);
    std::size_t local = 0;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = bad.triangles[t];
      const auto ball = certify::exact_surface_ball(good.skin.surface, located[a], bad.positions[b],
                                                    bad.positions[c]);
      bool is_entered = false;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const auto h = geometry::SurfaceMesh::half_edge(geometry::TriangleId{t}, k);
        const Point& apex = bad.positions[mesh.apex(mesh.twin(h)).index()];
        is_entered = is_entered || ball.intrusion(apex) > 1e-8 * ball.squared_radius;
      }
      local += is_entered && counts(ball, {&located[a], &located[b], &located[c]});
    }
    CHECK(local_violations(good, bad) == local);
    CHECK(good.certify(good.mesh).restricted_delaunay_violations == 0);
    CHECK(local > 0);
    CHECK(local <= expected);
    ++seen;
  });
  CHECK(seen >= 3);
}

TEST_CASE("one edge flipped makes two triangles that are not Delaunay, for both counts") {
  const Good good = vdw("caffeine.xyz");
  const auto located = certify::locate_vertices(good.mesh, good.skin.surface);
  for_seeds<Random>(20, [&](Random& random) {
    auto mesh = geometry::closed_mesh(good.mesh.positions.size(), good.mesh.triangles).mesh;
    const geometry::HalfEdgeId h{random.below(3 * mesh.triangle_count())};
    if (mesh.has_edge(mesh.apex(h), mesh.apex(mesh.twin(h)))) return;
    mesh.flip(h);
    const IndexedMesh bad{good.mesh.positions, mesh.triangle_list()};
    CHECK(local_violations(good, bad) == 2);
    CHECK(good.delaunay(bad).violations == 2);
  });
}

TEST_CASE("a vertex of another sheet in a surface ball counts, though no neighbour is") {
  const Good good({ball(0, 0, 0, 1), ball(9, 0, 0, 1.2)});
  IndexedMesh bad = good.mesh;
  // A lone vertex right over the middle of triangle 0, that no triangle knows.
  const auto& [a, b, c] = bad.triangles[0];
  bad.positions.push_back((bad.positions[a] + bad.positions[b] + bad.positions[c]) / 3);
  const certify::RestrictedDelaunay found = good.delaunay(bad);
  CHECK(found.violations >= 1);
  CHECK(std::ranges::any_of(found.deepest, [](const auto& v) { return v.triangle == 0; }));
  CHECK(found.deepest[0].vertex == bad.positions.size() - 1);
}

TEST_CASE("hardly any triangle needs its surface ball computed") {
  const Good good = vdw("caffeine.xyz");
  const certify::RestrictedDelaunay found = good.delaunay(good.mesh);
  CHECK(found.violations == 0);
  CHECK(found.exact_balls < good.mesh.triangles.size() / 10);
}

TEST_CASE("no ball is sought for the triangles of a mesh that has nothing to do with the skin") {
  const Good good = vdw("caffeine.xyz");
  IndexedMesh shuffled = good.mesh;
  Random random(1);
  random.shuffle(shuffled.positions);
  const certify::RestrictedDelaunay found = good.delaunay(shuffled);
  CHECK(found.exact_balls < shuffled.triangles.size() / 50);
  CHECK(found.undecided > shuffled.triangles.size() * 9 / 10);
  CHECK_FALSE(good.certify(shuffled).is_homeomorphic);
}
