// Regular triangulations of points that span less than space.

#include <doctest/doctest.h>

#include "tests/support/seeds.h"
#include "tests/support/triangulations.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

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
  support::for_seeds(200, [&](unsigned seed) {
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
  });
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
  support::for_seeds(200, [&](unsigned seed) {
    Points points = whole_points(seed, 4 + seed % 20, 3);
    for (WeightedPoint& p : points) p.position.z() = p.position.x() - 2 * p.position.y();
    const RegularTriangulation flat = regular_triangulation(points);
    check_complex(points, flat);
    if (flat.dimension != 2) return;
    points.push_back({{1, 1, 50}, 3});
    const RegularTriangulation cone = regular_triangulation(points);
    CHECK(cone.dimension == 3);
    std::vector<std::array<AtomId, 3>> floor;
    for (const auto& tetrahedron : cone.tetrahedra) floor.push_back(without(tetrahedron, 3));
    CHECK(floor == flat.triangles);
  });
}

TEST_CASE("flat points are triangulated at the ends of the exact range") {
  for (const double unit : {0x1p-120, 0x1p27}) {
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
