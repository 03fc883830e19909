#include "geometry/kd_tree.h"

#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::support;
using geometry::Point;
using geometry::VertexId;
using Tree = geometry::KdTree<VertexId>;

namespace {

/// 0 to 200 points: spread out, on a line, on a small lattice (many duplicates), or all one.
std::vector<Point> point_set(unsigned seed) {
  Random random(seed);
  std::vector<Point> points(seed < 20 ? seed : random.below(200));
  const unsigned kind = seed % 4;
  const Point start = 10 * random.direction();
  const geometry::Vector along = random.direction();
  for (Point& p : points) {
    if (kind == 0) p = start + random.between(0, 5) * random.direction();
    if (kind == 1) p = start + random.between(-5, 5) * along;
    if (kind == 2) {
      for (Eigen::Index k = 0; k < 3; ++k) p[k] = static_cast<double>(random.below(4));
    }
    if (kind == 3) p = start;
  }
  return points;
}

/// A place to ask about: at a point, near one, or far away.
Point question(const std::vector<Point>& points, Random& random) {
  const Point from = points.empty() ? Point::Zero() : points[random.below(points.size())];
  return from + std::array{0.0, 0.1, 1.0, 20.0}[random.below(4)] * random.direction();
}

}  // namespace

TEST_CASE("the nearest point within a radius is the one that a search of all points finds first") {
  std::size_t found = 0;
  for_seeds<Random>(400, [&](unsigned seed, Random& random) {
    const std::vector<Point> points = point_set(seed);
    const Tree tree(points);
    CHECK(tree.size() == points.size());
    for (int i = 0; i < 20; ++i) {
      const Point x = question(points, random);
      const double radius = std::array{0.0, 0.5, 3.0, 1e9}[random.below(4)];
      const auto accept = [&](VertexId id) { return i % 2 == 0 || id.value % 3 != 1; };
      std::optional<Tree::Neighbour> expected;
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        const double squared = (points[p] - x).squaredNorm();
        if (accept(VertexId{p}) && squared <= radius * radius &&
            (!expected || squared < expected->squared_distance)) {
          expected = {VertexId{p}, squared};
        }
      }
      const auto nearest = tree.nearest(x, radius, accept);
      REQUIRE(nearest.has_value() == expected.has_value());
      if (!expected) continue;
      ++found;
      CHECK(nearest->id == expected->id);
      CHECK(nearest->squared_distance == expected->squared_distance);
    }
  });
  CHECK(found > 1000);
}

TEST_CASE("the points within a radius are visited once each, and no others") {
  std::size_t found = 0;
  for_seeds<Random>(400, [&](unsigned seed, Random& random) {
    const std::vector<Point> points = point_set(seed);
    const Tree tree(points);
    for (int i = 0; i < 10; ++i) {
      const Point x = question(points, random);
      // On the lattice a radius of 1 has many points at just that distance.
      const double radius = std::array{0.0, 1.0, 3.0, 1e9}[random.below(4)];
      std::vector<int> visits(points.size()), expected(points.size());
      for (std::size_t p = 0; p < points.size(); ++p) {
        expected[p] = (points[p] - x).squaredNorm() <= radius * radius;
        found += static_cast<std::size_t>(expected[p]);
      }
      tree.for_each_within(x, radius, [&](const Tree::Neighbour& near) {
        ++visits[near.id.index()];
        CHECK(near.squared_distance == (points[near.id.index()] - x).squaredNorm());
      });
      CHECK(visits == expected);
    }
  });
  CHECK(found > 1000);
}

TEST_CASE("a tree of no points answers that there is none") {
  const Tree tree(std::vector<Point>{});
  CHECK_FALSE(tree.nearest(Point::Zero(), INFINITY));
  tree.for_each_within(Point::Zero(), INFINITY, [](const Tree::Neighbour&) { FAIL("a point"); });
}
