// Regular triangulations of points that span less than space.

#include "tests/support/triangulations.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

TEST_CASE("no points and single points are triangulated") {
  const RegularTriangulation none = checked_triangulation({});
  CHECK(none.dimension == -1);
  const Points one{{{1, 2, 3}, -4}};
  const RegularTriangulation t = checked_triangulation(one);
  CHECK(t.dimension == 0);
  CHECK(t.vertices == std::vector{AtomId(0u)});
}

TEST_CASE("two and three points are an edge and a triangle") {
  const Points two{{{0, 0, 0}, 1}, {{1, 1, 1}, 0.5}};
  const RegularTriangulation edge = checked_triangulation(two);
  CHECK(edge.dimension == 1);
  CHECK(edge.edges.size() == 1);
  const Points three{{{0, 0, 0}, 1}, {{1, 1, 1}, 0.5}, {{3, 0, 0}, 0}};
  const RegularTriangulation triangle = checked_triangulation(three);
  CHECK(triangle.dimension == 2);
  CHECK(triangle.triangles.size() == 1);
  // A ball deep inside a heavier one is no vertex.
  const Points nested{{{0, 0, 0}, 100}, {{1, 1, 1}, 0.5}};
  const RegularTriangulation shallow = regular_triangulation(nested);
  CHECK(shallow.edges.size() == 1);
  const Points between{{{0, 0, 0}, 1}, {{1, 0, 0}, -2}, {{2, 0, 0}, 1}};
  CHECK(regular_triangulation(between).hidden == std::vector{AtomId(1u)});
}

TEST_CASE("points on a line give the path of those on the lower hull") {
  for_seeds<Random>(200, [&](unsigned seed, Random& random) {
    const Point start(0.5, -3, 7), direction(1, seed % 2 == 0 ? 2 : 0, -3);
    Points points(3 + seed % 30);
    for (WeightedPoint& p : points) {
      p.position = start + direction * random.whole(-20, 20);
      p.weight = random.whole(-20, 20);
    }
    const RegularTriangulation t = checked_triangulation(points);
    CHECK(t.dimension == 1);
    CHECK(t.edges.size() + 1 == t.vertices.size());
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
    const RegularTriangulation t = checked_triangulation(points);
    CHECK(t.dimension == 2);
    CHECK(t.triangles.size() == 32);
    CHECK(t.edges.size() == 56);
    CHECK(t.hidden.empty());
  }
}

TEST_CASE("a planar triangulation is the floor of the cone over it") {
  for_seeds(200, [&](unsigned seed) {
    Points points = whole_points(seed, 4 + seed % 20, 3);
    for (WeightedPoint& p : points) p.position.z() = p.position.x() - 2 * p.position.y();
    const RegularTriangulation flat = checked_triangulation(points);
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
      const RegularTriangulation plane = checked_triangulation(points);
      CHECK(plane.dimension == 2);
      for (WeightedPoint& p : points) p.position[(axis + 1) % 3] = 0x1p30;
      const RegularTriangulation line = checked_triangulation(points);
      CHECK(line.dimension == 1);
      CHECK(line.edges.size() == 6);
    }
  }
}
