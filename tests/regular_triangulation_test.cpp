#include "geometry/regular_triangulation.h"

#include <Eigen/LU>
#include <ctime>

#include "geometry/predicates.h"
#include "tests/support/triangulations.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

/// The tetrahedra of the definition: four points with no fifth inside their orthosphere.
std::vector<std::array<AtomId, 4>> brute_force_tetrahedra(const Points& points) {
  std::vector<std::array<AtomId, 4>> result;
  const std::size_t n = points.size();
  const auto is_empty = [&](const std::array<std::size_t, 4>& c) {
    for (std::size_t e = 0; e < n; ++e) {
      if (std::find(c.begin(), c.end(), e) != c.end()) continue;
      if (orthosphere_side(points[c[0]], points[c[1]], points[c[2]], points[c[3]], points[e],
                           {AtomId(c[0]), AtomId(c[1]), AtomId(c[2]), AtomId(c[3]), AtomId(e)}) ==
          Side::Inside) {
        return false;
      }
    }
    return true;
  };
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        for (std::size_t d = c + 1; d < n; ++d) {
          std::array<std::size_t, 4> corners{a, b, c, d};
          const Sign sign = orientation(points[a].position, points[b].position, points[c].position,
                                        points[d].position);
          if (sign == Sign::Zero) continue;
          if (sign == Sign::Negative) std::swap(corners[0], corners[1]);
          if (is_empty(corners)) {
            result.push_back({AtomId(a), AtomId(b), AtomId(c), AtomId(d)});
          }
        }
      }
    }
  }
  return result;
}

Eigen::Matrix3d edges_of(const Points& points, const std::array<AtomId, 4>& t) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) {
    edges.col(k) =
        points[t[static_cast<std::size_t>(k) + 1].index()].position - points[t[0].index()].position;
  }
  return edges;
}

double volume(const Points& points, const RegularTriangulation& t) {
  double sum = 0;
  for (const auto& tetrahedron : t.tetrahedra) {
    sum += std::fabs(edges_of(points, tetrahedron).determinant()) / 6;
  }
  return sum;
}

/// How far above the lower hull of the lifted tetrahedron that contains it a point is lifted.
double height_above_hull(const Points& points, const RegularTriangulation& t, AtomId id) {
  const WeightedPoint& p = points[id.index()];
  const auto height = [](const WeightedPoint& q) { return q.position.squaredNorm() - q.weight; };
  double best = -1;
  double result = -1;
  for (const auto& tetrahedron : t.tetrahedra) {
    const WeightedPoint& origin = points[tetrahedron[0].index()];
    const Eigen::Vector3d share =
        edges_of(points, tetrahedron).fullPivLu().solve(p.position - origin.position);
    const double depth = std::min(share.minCoeff(), 1 - share.sum());
    if (depth <= best) continue;
    best = depth;
    double hull = (1 - share.sum()) * height(origin);
    for (int k = 0; k < 3; ++k) {
      hull += share[k] * height(points[tetrahedron[static_cast<std::size_t>(k) + 1].index()]);
    }
    result = height(p) - hull;
  }
  CHECK(best > -1e-9);
  return result;
}

}  // namespace

TEST_CASE("twelve random weighted points give the tetrahedra of the definition") {
  for_seeds(400, [&](unsigned seed) {
    const Points points = random_points(seed, 4 + seed % 9, seed % 4 == 0 ? 0 : 0.2 * (seed % 4));
    const RegularTriangulation t = checked_triangulation(points);
    CHECK(t.tetrahedra == brute_force_tetrahedra(points));
    for (const AtomId id : t.hidden) CHECK(height_above_hull(points, t, id) > 0);
  });
}

TEST_CASE("points full of ties give the tetrahedra of the definition under ties by id") {
  for_seeds(600, [&](unsigned seed) {
    const Points points = whole_points(seed, 4 + seed % 11, 1 + static_cast<int>(seed % 3));
    const RegularTriangulation t = checked_triangulation(points);
    CHECK(t.tetrahedra == brute_force_tetrahedra(points));
  });
}

TEST_CASE("the tetrahedra fill the convex hull once") {
  for_seeds(30, [&](unsigned seed) {
    // The corners of a box with everything else inside it: the hull's volume is known.
    Points points = random_points(seed, 300, seed % 2 == 0 ? 0 : 0.01);
    for (int corner = 0; corner < 8; ++corner) {
      points.push_back(
          {{(corner & 1) * 2.0 - 0.5, (corner >> 1 & 1) * 3.0 - 1, (corner >> 2 & 1) * 1.5 - 0.25},
           0});
    }
    const RegularTriangulation t = checked_triangulation(points);
    CHECK(volume(points, t) == doctest::Approx(2 * 3 * 1.5));
  });
}

TEST_CASE("of equal points the heaviest stays, the smallest id if equal") {
  const Points equal{{{1, 2, 3}, 1}, {{1, 2, 3}, 5}, {{1, 2, 3}, 5}, {{1, 2, 3}, -1}};
  const RegularTriangulation t = checked_triangulation(equal);
  CHECK(t.dimension == 0);
  CHECK(t.vertices == std::vector{AtomId(1u)});

  for_seeds(20, [&](unsigned seed) {
    Points points = random_points(seed, 50, 0);
    for (std::size_t i = 0; i < 50; ++i) points.push_back(points[i]);
    for (std::size_t i = 0; i < 50; i += 2) points[50 + i].weight = 1e-9;
    const RegularTriangulation doubled = checked_triangulation(points);
    CHECK(doubled.vertices.size() == 50);
    for (const AtomId id : doubled.vertices) {
      CHECK((id.index() < 50 ? id.index() % 2 == 1 : id.index() % 2 == 0));
    }
  });
}

TEST_CASE("cospherical points are triangulated without a hidden corner") {
  const Points cube = lattice(2, 2, 2);
  const RegularTriangulation t = checked_triangulation(cube);
  CHECK(t.hidden.empty());
  CHECK(volume(cube, t) == doctest::Approx(1));
  CHECK((t.tetrahedra.size() == 5 || t.tetrahedra.size() == 6));

  const Points octahedron{unweighted(1, 0, 0),  unweighted(-1, 0, 0), unweighted(0, 1, 0),
                          unweighted(0, -1, 0), unweighted(0, 0, 1),  unweighted(0, 0, -1)};
  const RegularTriangulation o = checked_triangulation(octahedron);
  CHECK(o.tetrahedra.size() == 4);
  CHECK(volume(octahedron, o) == doctest::Approx(4.0 / 3));
}

TEST_CASE("a lattice of eight thousand points takes less than three seconds of a processor") {
  for (const double step : {1.0, 0.1}) {
    CAPTURE(step);
    const Points points = lattice(20, 20, 20, step);
    // Processor time, for others may use the machine too.
    const std::clock_t start = std::clock();
    const RegularTriangulation t = checked_triangulation(points);
    const double elapsed = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
#ifdef NDEBUG
    CHECK(elapsed < 3);
#endif
    CHECK(elapsed < 60);
    CHECK(t.vertices.size() == 8000);
    CHECK(volume(points, t) == doctest::Approx(std::pow(19 * step, 3)));
  }
}

TEST_CASE("balls nested in heavier ones are hidden") {
  Points points = random_points(5, 200, 0);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].weight = i == 0 ? 10 : 0.0;
  points[0].position = Point(0.5, 0.5, 0.5);
  for (int corner = 0; corner < 8; ++corner) {
    points.push_back(
        {{(corner & 1) * 9.0 - 4, (corner >> 1 & 1) * 9.0 - 4, (corner >> 2 & 1) * 9.0 - 4}, 0});
  }
  const RegularTriangulation t = checked_triangulation(points);
  CHECK(t.vertices.size() == 9);
  for (const AtomId id : t.hidden) CHECK(height_above_hull(points, t, id) > 0);
}

TEST_CASE("many points on one sphere around a centre need no table of fixed size") {
  // The centre inserted among them has hundreds of neighbours.
  Random random(3);
  Points points{{{0, 0, 0}, 0}};
  for (int i = 0; i < 1500; ++i) points.push_back({random.direction(), 0});
  const RegularTriangulation t = checked_triangulation(points);
  CHECK(t.vertices.size() == 1501);
  CHECK(t.tetrahedra.size() == 2 * 1500 - 4);
}

TEST_CASE("shuffled points give the same simplices when nothing is degenerate") {
  for_seeds(20, [&](unsigned seed) {
    const Points points = random_points(seed, 400, 0.02);
    const RegularTriangulation t = regular_triangulation(points);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random(seed).shuffle(order);
    Points shuffled;
    for (const std::size_t i : order) shuffled.push_back(points[i]);
    auto tetrahedra = regular_triangulation(shuffled).tetrahedra;
    for (auto& tetrahedron : tetrahedra) {
      for (AtomId& id : tetrahedron) id = AtomId(order[id.index()]);
      std::sort(tetrahedron.begin(), tetrahedron.end());
    }
    std::sort(tetrahedra.begin(), tetrahedra.end());
    CHECK(tetrahedra == t.tetrahedra);
  });
}

TEST_CASE("the complex is the same for any number of threads") {
  Points points = random_points(7, 20000, 0.02);
  points.push_back({{0.5, 0.5, 0.5}, 0.1});  // with hundreds of neighbours
  const RegularTriangulation one = checked_triangulation(points);
  for (const unsigned threads : {2U, 3U, 8U}) {
    const RegularTriangulation t = regular_triangulation(points, Run(threads));
    CHECK(t.vertices == one.vertices);
    CHECK(t.edges == one.edges);
    CHECK(t.triangles == one.triangles);
    CHECK(t.tetrahedra == one.tetrahedra);
    CHECK(t.triangle_edges == one.triangle_edges);
    CHECK(t.tetrahedron_triangles == one.tetrahedron_triangles);
  }
}
