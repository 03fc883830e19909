#include "bench/baselines/kept_delaunay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "bench/baselines/dynamic_skin.h"
#include "geometry/predicates.h"
#include "geometry/regular_triangulation.h"
#include "morskin/pipeline.h"
#include "tests/support/ball_sets.h"
#include "tests/support/meshes.h"
#include "tests/support/molecules.h"

using namespace morskin;
using namespace morskin::baselines;
using geometry::AtomId;
using geometry::Point;
using geometry::Triangulator;
using support::ball;

namespace {

using Corner = Triangulator::Corner;
using Tetrahedra = std::vector<std::array<Corner, 4>>;

/// The corners where there is a sample.
std::vector<Corner> corners_in(const KeptDelaunay& kept) {
  std::vector<Corner> corners;
  // No more corners than that have ever been.
  for (Corner c = 0; c < kept.counts().insertions; ++c) {
    if (kept.vertex(c)) corners.push_back(c);
  }
  return corners;
}

Tetrahedra kept_tetrahedra(const KeptDelaunay& kept) {
  Tetrahedra result;
  if (kept.triangulation() == nullptr) return result;
  const Triangulator& delaunay = *kept.triangulation();
  for (std::size_t i = 0; i < delaunay.tetrahedra().size(); ++i) {
    if (!delaunay.is_live(i) || delaunay.is_ghost(delaunay.tetrahedra()[i])) continue;
    result.push_back(delaunay.tetrahedra()[i].corners);
    std::ranges::sort(result.back());
  }
  std::ranges::sort(result);
  return result;
}

/// Those of a triangulation made at once of the same points, in the order of their ids.
Tetrahedra fresh_tetrahedra(const KeptDelaunay& kept) {
  Tetrahedra result;
  if (kept.triangulation() == nullptr) return result;
  std::vector<Corner> corners = corners_in(kept);
  std::ranges::sort(corners, {}, [&](Corner c) { return *kept.triangulation()->atom(c); });
  std::vector<geometry::WeightedPoint> points;
  for (const Corner c : corners) points.push_back(kept.triangulation()->point(c));
  for (const auto& tetrahedron : geometry::regular_triangulation(points).tetrahedra) {
    auto& t = result.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) t[k] = corners[tetrahedron[k].index()];
    std::ranges::sort(t);
  }
  std::ranges::sort(result);
  return result;
}

/// The samples that are in or wait, ascending.
std::vector<VertexId> samples(const KeptDelaunay& kept) {
  std::vector<VertexId> result(kept.waiting().begin(), kept.waiting().end());
  for (const Corner c : corners_in(kept)) result.push_back(*kept.vertex(c));
  std::ranges::sort(result);
  return result;
}

std::vector<VertexId> vertices_of(const SurfaceMesh& surface) {
  std::vector<VertexId> result;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    if (surface.outgoing(VertexId{v})) result.push_back(VertexId{v});
  }
  return result;
}

/// Grows a skin, compares what is kept with a fresh triangulation before and after every
/// metamorphosis, and the mesh with it at the end.
///
/// @param C  of the sizing; a coarse mesh is quicker
void check_growth(const support::WeightedPoints& points, std::size_t least_moved,
                  double C = certify::Sizing().C) {
  const auto skin = support::prepared(points);
  REQUIRE(skin.has_value());
  KeptDelaunay kept;
  GrowthOptions options;
  options.kept = &kept;
  std::size_t compared = 0;
  options.observer = [&](const Metamorphosis&, const SurfaceMesh& surface, bool) {
    CHECK(samples(kept) == vertices_of(surface));
    CHECK(kept.waiting().empty());
    CHECK(kept_tetrahedra(kept) == fresh_tetrahedra(kept));
    ++compared;
  };
  morskin::MeshingOptions meshing;
  meshing.method = morskin::Method::Dynamic;
  meshing.sizing.C = C;
  meshing.sizing.Q = certify::Sizing::quality_for(C);
  meshing.mesher = dynamic_mesher(options);
  const morskin::MeshResult result = morskin::make_mesh(*skin, meshing);
  CHECK(compared > 0);
  CHECK(result.certificate.certified);
  CHECK(kept_tetrahedra(kept) == fresh_tetrahedra(kept));
  const KeptDelaunayCounts counts = kept.counts();
  CHECK(counts.samples == result.mesh.positions.size());
  CHECK(counts.insertions - counts.removals == counts.samples);
  CHECK(counts.moved_in_place + counts.moved_by_both >= least_moved);
  CHECK(counts.facets == result.mesh.triangles.size());
  CHECK(counts.facets_missing == 0);
  CHECK(counts.facets_not_crossed == 0);

  meshing.mesher = dynamic_mesher();
  const morskin::MeshResult without = morskin::make_mesh(*skin, meshing);
  CHECK(without.mesh.positions == result.mesh.positions);
  CHECK(without.mesh.triangles == result.mesh.triangles);
}

}  // namespace

TEST_CASE("what is kept of samples that come, go, move and meet is their triangulation") {
  std::size_t flat = 0, waited = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    KeptDelaunay kept;
    std::vector<std::optional<Point>> places;  // by vertex
    const auto place = [&]() -> Point {
      if (seed % 3 == 0) return Point(random.uniform(), random.uniform(), random.uniform());
      const auto whole = [&] { return static_cast<double>(random.below(3)); };
      const double x = whole(), y = whole();
      return Point(x, y, seed % 3 == 1 ? whole() : random.uniform() < 0.9 ? 0.0 : 1.0);
    };
    for (int step = 0; step < 200; ++step) {
      const double kind = random.uniform();
      const std::size_t v = places.empty() ? 0 : random.below(places.size());
      if (kind < 0.35 || places.empty()) {
        places.push_back(place());
        kept.add(VertexId{places.size() - 1}, *places.back());
      } else if (kind < 0.65) {
        if (places[v]) places[v] = place();
        kept.move(VertexId{v}, places[v].value_or(Point::Zero()));
      } else if (kind < 0.97) {
        places[v].reset();
        kept.remove(VertexId{v});
      } else {
        std::vector<std::optional<VertexId>> names(places.size());
        std::vector<std::optional<Point>> left;
        for (std::size_t old = 0; old < places.size(); ++old) {
          if (!places[old]) continue;
          names[old] = VertexId{left.size()};
          left.push_back(places[old]);
        }
        kept.rename(names);
        places = left;
      }
      std::vector<VertexId> expected;
      for (std::size_t w = 0; w < places.size(); ++w) {
        if (places[w]) expected.push_back(VertexId{w});
      }
      REQUIRE(samples(kept) == expected);
      REQUIRE(kept_tetrahedra(kept) == fresh_tetrahedra(kept));
      for (const Corner c : corners_in(kept)) {
        REQUIRE(kept.triangulation()->point(c).position == *places[kept.vertex(c)->index()]);
      }
      if (kept.triangulation() == nullptr) {
        std::vector<geometry::WeightedPoint> points;
        for (const VertexId w : expected) points.push_back({*places[w.index()], 0});
        REQUIRE(geometry::regular_triangulation(points).dimension < 3);
        ++flat;
      } else {
        // Only what is where another is waits.
        for (const VertexId w : kept.waiting()) {
          REQUIRE(std::ranges::any_of(corners_in(kept), [&](Corner c) {
            return kept.triangulation()->point(c).position == *places[w.index()];
          }));
          ++waited;
        }
      }
    }
  }
  CHECK(flat > 100);
  CHECK(waited > 100);
}

TEST_CASE("what is kept of a growing ball is its samples' triangulation, and the mesh is of it") {
  check_growth({ball(0, 0, 0, 1)}, 300);
}

TEST_CASE("what is kept of two balls that join in a neck is their samples' triangulation") {
  check_growth({ball(0, 0, 0, 1), ball(2, 0.1, 0, 1.2)}, 1000, 0.16);
}

TEST_SUITE("slow") {
  TEST_CASE("what is kept through all four metamorphoses is the samples' triangulation") {
    check_growth({ball(0, 0, 0, 1), ball(2, 0.1, 0, 1.2)}, 10000);
    check_growth(support::tetrahedron_balls(3.4), 10000);
  }
}
