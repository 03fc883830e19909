#include "refine/delaunay_refinement.h"

#include "front/static_method.h"
#include "geometry/kd_tree.h"
#include "skin/skin_components.h"
#include "tests/support/meshes.h"
#include "tests/support/molecules.h"
#include "tests/support/nasty_sets.h"

using namespace morskin;
using namespace morskin::refine;
using namespace morskin::support;

namespace {

std::vector<SurfacePoint> seeds_of(const PreparedSkin& skin, const Sizing& sizing = {}) {
  const auto chosen =
      morse::choose_function(skin.surface, skin.topology.skin_euler_characteristic(), {});
  return front::delaunay_seeds(skin.surface, chosen.critical.points, sizing);
}

template <class SurfacePoints>
std::vector<Point> positions(const SurfacePoints& points) {
  std::vector<Point> list;
  for (const SurfacePoint& p : points) list.push_back(p.position);
  return list;
}

using Triple = std::array<std::uint32_t, 3>;

/// Zeros of G on the line of points that are as far from a as from b and c, found among many
/// points within `extent` of the triangle's plane.
std::vector<Point> centres(const skin::SkinSurface& skin, const Point& a, const Point& b,
                           const Point& c, double extent) {
  const certify::Circumcircle circle = certify::circumcircle(a, b, c);
  const Vector n = circle.doubled_area.normalized();
  const auto value = [&](double h) {
    return skin.value(circle.centre + h * n, geometry::CellId{0U});
  };
  std::vector<Point> found;
  constexpr int steps = 60;
  for (int i = 0; i < steps; ++i) {
    double low = extent * (2.0 * i / steps - 1), high = extent * (2.0 * (i + 1) / steps - 1);
    const bool is_outside = value(low) > 0;
    if ((value(high) > 0) == is_outside) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      ((value(middle) > 0) == is_outside ? low : high) = middle;
    }
    found.push_back(circle.centre + low * n);
  }
  return found;
}

}  // namespace

TEST_CASE("the mesh is the triples of samples with an empty ball about a point of the skin") {
  for_seeds<Random>(12, [&](unsigned seed, Random& random) {
    std::vector<geometry::WeightedPoint> balls;
    for (unsigned i = 0; i <= seed % 4; ++i) {
      balls.push_back(ball(random.between(0, 3), random.between(0, 3), random.between(0, 3),
                           random.between(0.8, 1.6)));
    }
    const auto skin = prepared(balls);
    if (!skin) return;
    const Sizing coarse{.C = 0.125, .Q = 1.69};  // CQ = 0.21
    DelaunayRefinement refinement(skin->surface, coarse, seeds_of(*skin, coarse));
    refinement.run();
    const surface::Mesh mesh = refinement.mesh();
    const std::vector<Point> points = positions(mesh.points);
    REQUIRE(points.size() == refinement.counts().seeds + refinement.counts().too_big);
    std::set<Triple> facets;
    for (Triple t : mesh.surface.triangle_list()) {
      std::sort(t.begin(), t.end());
      facets.insert(t);
    }
    const geometry::KdTree<VertexId> tree(points);
    std::size_t doubtful = 0, wrong = 0;
    for (std::uint32_t a = 0; a < points.size(); ++a) {
      // No empty ball of a dense sample is larger.
      const double extent = 0.35 * mesh.at(VertexId{a}).length_scale;
      std::vector<std::uint32_t> near;
      tree.for_each_within(points[a], 2 * extent, [&](const auto& n) {
        if (n.id.value > a) near.push_back(n.id.value);
      });
      for (const std::uint32_t b : near) {
        for (const std::uint32_t c : near) {
          if (b >= c) continue;
          bool is_facet = false, is_doubtful = false;
          for (const Point& x : centres(skin->surface, points[a], points[b], points[c], extent)) {
            const double r = (x - points[a]).norm();
            double least = INFINITY;
            for (const std::uint32_t p : near) {
              if (p != b && p != c) least = std::min(least, (points[p] - x).norm());
            }
            tree.for_each_within(x, 1.001 * r, [&](const auto& n) {
              const std::uint32_t p = n.id.value;
              if (p != a && p != b && p != c) {
                least = std::min(least, std::sqrt(n.squared_distance));
              }
            });
            is_doubtful |= std::abs(least - r) < 1e-7 * r;
            is_facet |= least > r;
          }
          doubtful += is_doubtful;
          wrong += !is_doubtful && is_facet != facets.contains({a, b, c});
        }
      }
    }
    CHECK(wrong == 0);
    CHECK(doubtful < points.size() / 10);
  });
}

TEST_CASE("every point of the skin has a sample within 0.153 of its length scale") {
  for_skins(20, [&](unsigned seed, const PreparedSkin& skin) {
    DelaunayRefinement refinement(skin.surface, {}, seeds_of(skin));
    refinement.run();
    const surface::Mesh mesh = refinement.mesh();
    const geometry::KdTree<VertexId> tree(positions(mesh.points));
    Random random(seed);
    const Box box = box_of(skin.surface.points());
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point x = box.sample(random);
      const auto p = skin.surface.project(x, skin.surface.locate(x, geometry::CellId{0U}));
      if (!p) continue;
      ++found;
      CHECK(tree.nearest(p->position, 0.153 * p->length_scale));
    }
    CHECK(found > 100);
  });
}

TEST_CASE("a component without seeds is found where dual points lie in it") {
  const WeightedPoints points{ball(0, 0, 0, 1), ball(7, 0, 0, 3)};
  const PreparedSkin skin = prepare_skin(points);
  std::vector<SurfacePoint> seeds = seeds_of(skin);
  std::erase_if(seeds, [](const SurfacePoint& p) { return p.position.x() > 2; });
  DelaunayRefinement refinement(skin.surface, {}, seeds);
  refinement.run();
  const surface::Mesh mesh = refinement.mesh();
  const certify::Certificate certificate = certify::certify(
      {positions(mesh.points), mesh.surface.triangle_list()}, skin.surface, skin.topology);
  CHECK(certificate.reason == "");
  CHECK(certificate.components == 2);
}

TEST_CASE("a ring that the signs miss without seeds at saddles is found along the dual edges") {
  // One minimum and one maximum: all circumcentres are on one side.
  const PreparedSkin skin = prepare_skin(molecule("ring12.xyzr", skin::Model::Sas));
  auto critical =
      morse::choose_function(skin.surface, skin.topology.skin_euler_characteristic(), {}).critical;
  std::erase_if(critical.points, [](const morse::CriticalPoint& p) { return p.index == 1; });
  DelaunayRefinement refinement(skin.surface, {},
                                front::delaunay_seeds(skin.surface, critical.points, {}));
  refinement.run();
  CHECK(refinement.counts().hidden_crossings > 0);
  const surface::Mesh mesh = refinement.mesh();
  const certify::Certificate certificate = certify::certify(
      {positions(mesh.points), mesh.surface.triangle_list()}, skin.surface, skin.topology);
  CHECK(certificate.reason == "");
  CHECK(certificate.euler_characteristic == 0);
}

TEST_CASE("a sizing too coarse for the topology ends with a mesh that has no border") {
  std::size_t most = 0;
  for_skins(40, [&](unsigned seed, const PreparedSkin& skin) {
    const Sizing coarse{.C = 0.3 + 0.01 * seed, .Q = 1.9};
    DelaunayRefinement refinement(skin.surface, coarse, seeds_of(skin, coarse));
    refinement.run();
    const auto triangles = refinement.mesh().surface.triangle_list();
    most = std::max(most, triangles.size());
    // A border there cannot be: each edge is passed as often one way as the other.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;
    for (const auto& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        passes[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    CHECK(std::ranges::all_of(passes, [](const auto& p) { return p.second == 0; }));
  });
  CHECK(most > 1000);
}

TEST_CASE("seeds in one plane give no mesh") {
  const PreparedSkin skin = prepare_skin({ball(0, 0, 0, 1)});
  std::vector<SurfacePoint> seeds = seeds_of(skin);
  for (const std::size_t count : {0, 1, 2, 3}) {
    DelaunayRefinement refinement(skin.surface, {}, std::span(seeds).first(count));
    refinement.run();
    CHECK(refinement.mesh().points.empty());
  }
}

TEST_CASE("seeds keep apart, and every component of the skin has a triangle of them") {
  for_seeds(300, [&](unsigned seed) {
    const auto skin = prepared(seed % 2 == 0 ? ball_set(seed) : nasty_set(seed));
    if (!skin) return;
    const skin::SkinComponents components(skin->surface, skin->topology);
    for (const double C : {0.08, 0.4}) {
      CAPTURE(C);
      const Sizing sizing{.C = C, .Q = Sizing::quality_for(C)};
      const std::vector<SurfacePoint> seeds = seeds_of(*skin, sizing);
      const geometry::KdTree<VertexId> tree(positions(seeds));
      std::map<skin::SkinComponents::Sides, std::size_t> count;
      bool is_apart = true;
      for (const SurfacePoint& p : seeds) {
        if (const auto sides = components.sides(p)) ++count[*sides];
        tree.for_each_within(p.position, p.length_scale, [&](const auto& n) {
          const SurfacePoint& q = seeds[n.id.index()];
          is_apart &= &p == &q || sizing.edge_ratio(p, q) > 1;
        });
      }
      // A coarse triangle shrinks when it is projected onto a component as small as itself.
      if (C <= Sizing::largest_proved_C) CHECK(is_apart);
      CHECK(count.size() == skin->topology.skin_components());
      CHECK(std::ranges::all_of(count, [](const auto& c) { return c.second >= 3; }));
    }
  });
}

TEST_CASE("no insertion makes a pair of samples that is too short for [L]") {
  std::size_t inserted = 0;
  for_seeds(10, [&](unsigned seed) {
    const auto skin = prepared(nasty_set(seed));
    if (!skin) return;
    const Sizing sizing{.C = 0.08, .Q = 1.584};  // the smallest Q with a proof
    DelaunayRefinement refinement(skin->surface, sizing, seeds_of(*skin, sizing));
    refinement.run();
    const surface::Mesh mesh = refinement.mesh();
    const geometry::KdTree<VertexId> tree(positions(mesh.points));
    std::size_t too_short = 0;
    for (const SurfacePoint& p : mesh.points) {
      tree.for_each_within(p.position, 0.2 * p.length_scale, [&](const auto& n) {
        const SurfacePoint& q = mesh.at(n.id);
        too_short += &p != &q && sizing.edge_ratio(p, q) <= 1;
      });
    }
    CHECK(too_short == 0);
    CHECK(refinement.counts().topological == 0);
    CHECK(refinement.counts().refused == 0);
    inserted += refinement.counts().too_big;
  });
  CHECK(inserted > 10'000);
}
