#include "certify/candidate_grid.h"

#include <cmath>

#include "certify/covering_degree.h"
#include "skin/skin_surface.h"
#include "tests/support/ball_sets.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::certify;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

/// Random points in a cube, and a length scale that varies a thousandfold and is 1-Lipschitz.
struct Samples {
  std::vector<Point> points;

  Samples(std::size_t count, unsigned seed) {
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
      // A third power draws some of them to the origin, where the length scale is small.
      const Point p = random.in_cube(-1, 1);
      points.push_back(p.norm() * p.norm() * p);
    }
  }
  double length_scale(std::size_t i) const { return 1e-3 + 0.9 * points[i].norm(); }
  std::vector<Candidate> candidates(std::size_t step) const {
    std::vector<Candidate> result;
    for (std::size_t i = 0; i < points.size(); i += step) {
      result.push_back({VertexId{i}, points[i], length_scale(i)});
    }
    return result;
  }
};

}  // namespace

TEST_CASE(
    "every candidate within the radius of a point is visited, as a search of all finds them") {
  std::size_t found = 0;
  for_seeds(20, [&](unsigned seed) {
    const Samples samples(1000, seed);
    for (const double radius : {0.01, 0.1, 0.3, 0.8}) {
      const std::vector<Candidate> candidates = samples.candidates(7);
      const CandidateGrid grid(radius, candidates);
      for (std::size_t i = 0; i < samples.points.size(); ++i) {
        const double rho = samples.length_scale(i);
        std::vector<char> is_visited(samples.points.size(), 0);
        grid.for_each_near(samples.points[i], rho, [&](VertexId v) { is_visited[v.index()] = 1; });
        for (const Candidate& candidate : candidates) {
          if ((candidate.position - samples.points[i]).norm() > radius * rho) continue;
          CHECK(is_visited[candidate.vertex.index()] != 0);
          ++found;
        }
      }
    }
  });
  CHECK(found > 10'000);  // so the law was put to the test
}

TEST_CASE("a query visits few of many candidates, however many there are") {
  // A capsid's mesh has thousands of components with sixteen candidates each. Buckets limited to
  // 65,536 once showed every vertex a hundred of them.
  Random random(1);
  std::vector<Point> points(100'000);
  for (Point& p : points) p = random.in_cube(0, 40);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < points.size(); ++i) candidates.push_back({VertexId{i}, points[i], 1});
  const double radius = 0.3;
  const CandidateGrid grid(radius, candidates);
  std::size_t visits = 0;
  constexpr std::size_t questions = 10'000;
  for (std::size_t i = 0; i < questions; ++i) {
    grid.for_each_near(candidates[i].position, 1, [&](VertexId) { ++visits; });
  }
  // 1.6 candidates to a unit cube, 27 cells of width 0.6 or less: nine in the cells themselves.
  CHECK(visits < 20 * questions);
}

TEST_CASE(
    "a triangle's image is within its bounds: over the length scale, or from its first corner") {
  constexpr double sure = 1e-6;
  FlowBounds near, far;
  near.add(3, 0.2, 0.1, 1.0, sure);
  CHECK(near.ratio() >= 0.3);
  CHECK(near.far().empty());
  near.add(4, 0.1, 0.1, 1.0, sure);
  CHECK(near.ratio() >= 0.3);  // the largest stays
  far.add(5, 0.5, 0.4, 1.0, sure);
  far.add(6, 0.2, 0.1, 1.0, 1.01 * FlowBounds::max_doubt);
  far.add(7, 0.2, 0.1, std::nan(""), sure);
  REQUIRE(far.far().size() == 3);
  CHECK(far.ratio() == 0);
  for (std::uint32_t i = 0; i < 3; ++i) CHECK(far.far()[i].triangle == 5 + i);
  CHECK(far.far()[0].from_first_corner >= 1.4F);
  CHECK(far.far()[1].from_first_corner >= 0.5F);
  FlowBounds all;
  all.add(far);
  all.add(near);
  all.add(far);
  CHECK(all.far().size() == 6);
  CHECK(all.ratio() == near.ratio());
}

TEST_CASE("a triangle's corners are bounded together, whichever is the worst") {
  const IndexedMesh mesh;
  const skin::SkinSurface skin({ball(0, 0, 0, 1)});
  for (std::uint32_t worst = 0; worst < 3; ++worst) {
    const Vector N(1, 0, 0);
    std::vector<LocatedVertex> vertices(3, LocatedVertex{N, -1, 1, 1, {}});
    vertices[worst] = {N, -3, 2, 5, {}};
    const LocatedMesh located{mesh, vertices, skin};
    const CornerBounds corners = located.corner_bounds({0, 1, 2});
    CHECK(corners.max_error == 5);
    CHECK(corners.max_values[worst] == 3);
    CHECK(corners.max_value() == 3);
  }
}
