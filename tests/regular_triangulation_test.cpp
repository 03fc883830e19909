#include "geometry/regular_triangulation.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/triangulator.h"

namespace morskin::geometry {
namespace {

using Points = std::vector<WeightedPoint>;

WeightedPoint unweighted(double x, double y, double z) { return {{x, y, z}, 0}; }

Points random_points(unsigned seed, std::size_t count, double largest_weight) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Points points(count);
  for (WeightedPoint& p : points) {
    for (int k = 0; k < 3; ++k) p.position[k] = unit(random);
    p.weight = largest_weight * unit(random);
  }
  return points;
}

/// Whole coordinates up to `range`: full of ties, duplicates and flat subsets.
Points whole_points(unsigned seed, std::size_t count, int range) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> coordinate(0, range);
  Points points(count);
  for (WeightedPoint& p : points) {
    for (int k = 0; k < 3; ++k) p.position[k] = coordinate(random);
    p.weight = coordinate(random);
  }
  return points;
}

Points lattice(int nx, int ny, int nz, double step = 1) {
  Points points;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      for (int k = 0; k < nz; ++k) points.push_back(unweighted(step * i, step * j, step * k));
    }
  }
  return points;
}

template <std::size_t Size>
std::array<AtomId, Size - 1> without(const std::array<AtomId, Size>& simplex, std::size_t corner) {
  std::array<AtomId, Size - 1> rest;
  std::copy_if(simplex.begin(), simplex.end(), rest.begin(),
               [&](AtomId id) { return id != simplex[corner]; });
  return rest;
}

template <std::size_t Size>
bool is_sorted_complex(const std::vector<std::array<AtomId, Size>>& simplices) {
  const auto ascends = [](const auto& simplex) {
    return std::adjacent_find(simplex.begin(), simplex.end(), std::greater_equal<>()) ==
           simplex.end();
  };
  return std::all_of(simplices.begin(), simplices.end(), ascends) &&
         std::adjacent_find(simplices.begin(), simplices.end(), std::greater_equal<>()) ==
             simplices.end();
}

/// What holds for every input: arrays sorted, faces found where they are said to be, every face of
/// lower dimension a face of one above, Euler characteristic 1, no atom lost.
void check_complex(const Points& points, const RegularTriangulation& t) {
  CHECK(std::is_sorted(t.vertices.begin(), t.vertices.end()));
  CHECK(std::is_sorted(t.hidden.begin(), t.hidden.end()));
  CHECK(is_sorted_complex(t.edges));
  CHECK(is_sorted_complex(t.triangles));
  CHECK(is_sorted_complex(t.tetrahedra));
  REQUIRE(t.triangle_edges.size() == t.triangles.size());
  REQUIRE(t.tetrahedron_triangles.size() == t.tetrahedra.size());
  std::vector<int> edge_uses(t.edges.size(), 0);
  std::vector<int> triangle_uses(t.triangles.size(), 0);
  bool places_are_right = true;
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      places_are_right &= t.edges[t.triangle_edges[i][k]] == without(t.triangles[i], k);
      ++edge_uses[t.triangle_edges[i][k]];
    }
  }
  for (std::size_t i = 0; i < t.tetrahedra.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      places_are_right &= t.triangles[t.tetrahedron_triangles[i][k]] == without(t.tetrahedra[i], k);
      ++triangle_uses[t.tetrahedron_triangles[i][k]];
    }
  }
  CHECK(places_are_right);
  if (t.dimension >= 2) CHECK(std::count(edge_uses.begin(), edge_uses.end(), 0) == 0);
  if (t.dimension == 3) {
    CHECK(std::all_of(triangle_uses.begin(), triangle_uses.end(),
                      [](int uses) { return uses == 1 || uses == 2; }));
  }
  std::vector<AtomId> atoms = t.vertices;
  atoms.insert(atoms.end(), t.hidden.begin(), t.hidden.end());
  std::sort(atoms.begin(), atoms.end());
  CHECK(atoms.size() == points.size());
  CHECK(std::adjacent_find(atoms.begin(), atoms.end()) == atoms.end());
  const auto count = [](const auto& simplices) { return static_cast<long>(simplices.size()); };
  CHECK(count(t.vertices) - count(t.edges) + count(t.triangles) - count(t.tetrahedra) ==
        (points.empty() ? 0 : 1));
}

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
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const Points points = random_points(seed, 4 + seed % 9, seed % 4 == 0 ? 0 : 0.2 * (seed % 4));
    const RegularTriangulation t = regular_triangulation(points);
    check_complex(points, t);
    CHECK(t.tetrahedra == brute_force_tetrahedra(points));
    for (const AtomId id : t.hidden) CHECK(height_above_hull(points, t, id) > 0);
  }
}

TEST_CASE("points full of ties give the tetrahedra of the definition under ties by id") {
  for (unsigned seed = 0; seed < 600; ++seed) {
    CAPTURE(seed);
    const Points points = whole_points(seed, 4 + seed % 11, 1 + static_cast<int>(seed % 3));
    const RegularTriangulation t = regular_triangulation(points);
    check_complex(points, t);
    CHECK(t.tetrahedra == brute_force_tetrahedra(points));
  }
}

TEST_CASE("the tetrahedra fill the convex hull once") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    // The corners of a box with everything else inside it: the hull's volume is known.
    Points points = random_points(seed, 300, seed % 2 == 0 ? 0 : 0.01);
    for (int corner = 0; corner < 8; ++corner) {
      points.push_back(
          {{(corner & 1) * 2.0 - 0.5, (corner >> 1 & 1) * 3.0 - 1, (corner >> 2 & 1) * 1.5 - 0.25},
           0});
    }
    const RegularTriangulation t = regular_triangulation(points);
    check_complex(points, t);
    CHECK(volume(points, t) == doctest::Approx(2 * 3 * 1.5));
  }
}

TEST_CASE("no points and single points are triangulated") {
  const RegularTriangulation none = regular_triangulation({});
  CHECK(none.dimension == -1);
  check_complex({}, none);
  const Points one{{{1, 2, 3}, -4}};
  const RegularTriangulation t = regular_triangulation(one);
  CHECK(t.dimension == 0);
  CHECK(t.vertices == std::vector{AtomId(0u)});
  check_complex(one, t);
}

TEST_CASE("of equal points the heaviest stays, the smallest id if equal") {
  const Points equal{{{1, 2, 3}, 1}, {{1, 2, 3}, 5}, {{1, 2, 3}, 5}, {{1, 2, 3}, -1}};
  const RegularTriangulation t = regular_triangulation(equal);
  CHECK(t.dimension == 0);
  CHECK(t.vertices == std::vector{AtomId(1u)});
  check_complex(equal, t);

  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Points points = random_points(seed, 50, 0);
    for (std::size_t i = 0; i < 50; ++i) points.push_back(points[i]);
    for (std::size_t i = 0; i < 50; i += 2) points[50 + i].weight = 1e-9;
    const RegularTriangulation doubled = regular_triangulation(points);
    check_complex(points, doubled);
    CHECK(doubled.vertices.size() == 50);
    for (const AtomId id : doubled.vertices) {
      CHECK((id.index() < 50 ? id.index() % 2 == 1 : id.index() % 2 == 0));
    }
  }
}

TEST_CASE("two and three points are an edge and a triangle") {
  const Points two{{{0, 0, 0}, 1}, {{1, 1, 1}, 0.5}};
  const RegularTriangulation edge = regular_triangulation(two);
  CHECK(edge.dimension == 1);
  CHECK(edge.edges.size() == 1);
  check_complex(two, edge);
  const Points three{{{0, 0, 0}, 1}, {{1, 1, 1}, 0.5}, {{3, 0, 0}, 0}};
  const RegularTriangulation triangle = regular_triangulation(three);
  CHECK(triangle.dimension == 2);
  CHECK(triangle.triangles.size() == 1);
  check_complex(three, triangle);
  // A ball deep inside a heavier one is no vertex.
  const Points nested{{{0, 0, 0}, 100}, {{1, 1, 1}, 0.5}};
  const RegularTriangulation shallow = regular_triangulation(nested);
  CHECK(shallow.edges.size() == 1);
  const Points between{{{0, 0, 0}, 1}, {{1, 0, 0}, -2}, {{2, 0, 0}, 1}};
  CHECK(regular_triangulation(between).hidden == std::vector{AtomId(1u)});
}

TEST_CASE("points on a line give the path of those on the lower hull") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> place(-20, 20);
    const Point start(0.5, -3, 7), direction(1, seed % 2 == 0 ? 2 : 0, -3);
    Points points(3 + seed % 30);
    for (WeightedPoint& p : points) {
      p.position = start + direction * place(random);
      p.weight = place(random);
    }
    const RegularTriangulation t = regular_triangulation(points);
    CHECK(t.dimension == 1);
    CHECK(t.edges.size() + 1 == t.vertices.size());
    check_complex(points, t);
  }
}

TEST_CASE("a planar grid is triangulated in its plane") {
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    Points points;
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) {
        Point p(i, j, 7);
        std::swap(p[axis], p[2]);
        points.push_back({p, 0});
      }
    }
    const RegularTriangulation t = regular_triangulation(points);
    CHECK(t.dimension == 2);
    CHECK(t.triangles.size() == 32);
    CHECK(t.edges.size() == 56);
    CHECK(t.hidden.empty());
    check_complex(points, t);
  }
}

TEST_CASE("a planar triangulation is the floor of the cone over it") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Points points = whole_points(seed, 4 + seed % 20, 3);
    for (WeightedPoint& p : points) p.position.z() = p.position.x() - 2 * p.position.y();
    const RegularTriangulation flat = regular_triangulation(points);
    check_complex(points, flat);
    if (flat.dimension != 2) continue;
    points.push_back({{1, 1, 50}, 3});
    const RegularTriangulation cone = regular_triangulation(points);
    CHECK(cone.dimension == 3);
    std::vector<std::array<AtomId, 3>> floor;
    for (const auto& tetrahedron : cone.tetrahedra) floor.push_back(without(tetrahedron, 3));
    CHECK(floor == flat.triangles);
  }
}

TEST_CASE("flat points are triangulated at the ends of the exact range") {
  for (const double unit : {0x1p-64, 0x1p27}) {
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(unit);
      CAPTURE(axis);
      Points points = whole_points(7, 40, 6);
      for (WeightedPoint& p : points) {
        p.position = (unit * p.position).eval();
        p.position[axis] = -0x1p30;
        p.weight = 0;
      }
      const RegularTriangulation plane = regular_triangulation(points);
      CHECK(plane.dimension == 2);
      check_complex(points, plane);
      for (WeightedPoint& p : points) p.position[(axis + 1) % 3] = 0x1p30;
      const RegularTriangulation line = regular_triangulation(points);
      CHECK(line.dimension == 1);
      CHECK(line.edges.size() == 6);
      check_complex(points, line);
    }
  }
}

TEST_CASE("cospherical points are triangulated without a hidden corner") {
  const Points cube = lattice(2, 2, 2);
  const RegularTriangulation t = regular_triangulation(cube);
  check_complex(cube, t);
  CHECK(t.hidden.empty());
  CHECK(volume(cube, t) == doctest::Approx(1));
  CHECK((t.tetrahedra.size() == 5 || t.tetrahedra.size() == 6));

  const Points octahedron{unweighted(1, 0, 0),  unweighted(-1, 0, 0), unweighted(0, 1, 0),
                          unweighted(0, -1, 0), unweighted(0, 0, 1),  unweighted(0, 0, -1)};
  const RegularTriangulation o = regular_triangulation(octahedron);
  check_complex(octahedron, o);
  CHECK(o.tetrahedra.size() == 4);
  CHECK(volume(octahedron, o) == doctest::Approx(4.0 / 3));
}

TEST_CASE("a lattice of eight thousand points takes less than three seconds") {
  for (const double step : {1.0, 0.1}) {
    CAPTURE(step);
    const Points points = lattice(20, 20, 20, step);
    const auto start = std::chrono::steady_clock::now();
    const RegularTriangulation t = regular_triangulation(points);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
#ifdef NDEBUG
    CHECK(elapsed.count() < 3);
#endif
    CHECK(elapsed.count() < 60);
    check_complex(points, t);
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
  const RegularTriangulation t = regular_triangulation(points);
  check_complex(points, t);
  CHECK(t.vertices.size() == 9);
  for (const AtomId id : t.hidden) CHECK(height_above_hull(points, t, id) > 0);
}

TEST_CASE("many points on one sphere around a centre need no table of fixed size") {
  // The centre inserted among them has hundreds of neighbours.
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Points points{{{0, 0, 0}, 0}};
  for (int i = 0; i < 1500; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random);
    points.push_back({Point(x, y, z).normalized(), 0});
  }
  const RegularTriangulation t = regular_triangulation(points);
  check_complex(points, t);
  CHECK(t.vertices.size() == 1501);
  CHECK(t.tetrahedra.size() == 2 * 1500 - 4);
}

TEST_CASE("shuffled points give the same simplices when nothing is degenerate") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const Points points = random_points(seed, 400, 0.02);
    const RegularTriangulation t = regular_triangulation(points);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(seed));
    Points shuffled;
    for (const std::size_t i : order) shuffled.push_back(points[i]);
    auto tetrahedra = regular_triangulation(shuffled).tetrahedra;
    for (auto& tetrahedron : tetrahedra) {
      for (AtomId& id : tetrahedron) id = AtomId(order[id.index()]);
      std::sort(tetrahedron.begin(), tetrahedron.end());
    }
    std::sort(tetrahedra.begin(), tetrahedra.end());
    CHECK(tetrahedra == t.tetrahedra);
  }
}

TEST_CASE("points added one by one give the triangulation of all at once") {
  std::vector<Points> sets{lattice(5, 5, 5), lattice(3, 4, 7, 0.1)};
  for (unsigned seed = 0; seed < 40; ++seed) sets.push_back(random_points(seed, 5 + 5 * seed, 0));
  // On a sphere, to rounding: every tetrahedron has nearly the same circumsphere.
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  sets.emplace_back();
  for (int i = 0; i < 300; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random);
    sets.back().push_back({Point(x, y, z).normalized(), 0});
  }
  for (Points& points : sets) {
    CAPTURE(points.size());
    std::shuffle(points.begin(), points.end(), random);
    std::size_t first = 4;
    while (regular_triangulation({points.begin(), points.begin() + static_cast<long>(first)})
               .dimension < 3) {
      ++first;
    }
    Triangulator triangulator(std::span<const WeightedPoint>(points).first(first));
    bool is_bookkeeping_right = true;
    for (std::size_t i = first; i < points.size(); ++i) {
      // Hints may be anywhere: any live tetrahedron will do.
      std::array<std::uint32_t, 2> hints{};
      for (std::uint32_t& hint : hints) {
        do {
          hint = static_cast<std::uint32_t>(random() % triangulator.tetrahedra().size());
        } while (!triangulator.is_live(hint));
      }
      const auto corner = triangulator.add(points[i], hints);
      REQUIRE(corner);
      is_bookkeeping_right &= *corner == i && triangulator.atom(*corner) == AtomId(i);
      for (const std::uint32_t t : triangulator.added()) {
        const auto& corners = triangulator.tetrahedra()[t].corners;
        is_bookkeeping_right &=
            triangulator.is_live(t) && std::ranges::count(corners, *corner) == 1;
      }
    }
    CHECK(is_bookkeeping_right);
    CHECK_FALSE(triangulator.add(points[0], {triangulator.added()[0], triangulator.added()[0]}));
    std::vector<std::array<AtomId, 4>> tetrahedra;
    for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
      const Triangulator::Tetrahedron& t = triangulator.tetrahedra()[i];
      if (!triangulator.is_live(i) || triangulator.is_ghost(t)) continue;
      std::array<AtomId, 4> ids;
      for (std::size_t k = 0; k < 4; ++k) ids[k] = *triangulator.atom(t.corners[k]);
      std::sort(ids.begin(), ids.end());
      tetrahedra.push_back(ids);
    }
    std::sort(tetrahedra.begin(), tetrahedra.end());
    CHECK(tetrahedra == regular_triangulation(points).tetrahedra);
  }
}

TEST_CASE("neighbouring tetrahedra of the triangulator know each other and share three corners") {
  for (const Points& points : {random_points(1, 500, 0.01), lattice(6, 6, 6), lattice(5, 5, 1)}) {
    const Triangulator triangulator(points);
    bool is_consistent = true;
    for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
      if (!triangulator.is_live(i)) continue;
      const Triangulator::Tetrahedron& t = triangulator.tetrahedra()[i];
      for (std::size_t k = 0; k < 4; ++k) {
        const Triangulator::Facet behind = t.neighbours[k];
        const std::uint32_t there = Triangulator::tetrahedron_of(behind);
        const std::size_t place = Triangulator::index_of(behind);
        const Triangulator::Tetrahedron& other = triangulator.tetrahedra()[there];
        auto mine = t.corners, theirs = other.corners;
        std::swap(mine[k], mine[3]);
        std::swap(theirs[place], theirs[3]);
        std::sort(mine.begin(), mine.end() - 1);
        std::sort(theirs.begin(), theirs.end() - 1);
        is_consistent &= triangulator.is_live(there) && other.neighbours[place] == 4 * i + k &&
                         std::equal(mine.begin(), mine.end() - 1, theirs.begin());
      }
    }
    CHECK(is_consistent);
  }
}

}  // namespace morskin::geometry
