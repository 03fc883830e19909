#include "certify/winding_number.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "tests/support/ball_sets.h"
#include "tests/support/good_mesh.h"
#include "tests/support/seeds.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::IndexedMesh;
using geometry::Point;

namespace {

/// A cube between two corners, its triangles facing out, or in.
IndexedMesh cube(const Point& low, const Point& high, bool faces_out = true) {
  IndexedMesh mesh;
  for (unsigned k = 0; k < 8; ++k) {
    mesh.positions.emplace_back((k & 1) != 0 ? high.x() : low.x(),
                                (k & 2) != 0 ? high.y() : low.y(),
                                (k & 4) != 0 ? high.z() : low.z());
  }
  for (const auto& [a, b, c, d] : std::vector<std::array<std::uint32_t, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    mesh.triangles.push_back({a, faces_out ? b : c, faces_out ? c : b});
    mesh.triangles.push_back({a, faces_out ? c : d, faces_out ? d : c});
  }
  return mesh;
}

}  // namespace

TEST_CASE("a cube goes once round its inside, under its corners and edges too") {
  for (const double scale : {1.0, 1e-200, 1e200, 0x1p29}) {
    const IndexedMesh mesh = cube(Point::Constant(-scale), Point::Constant(scale));
    std::vector<Point> points;
    std::vector<int> expected;
    // On a grid of quarters, all below vertices, edges and diagonals.
    for (int i = -6; i <= 6; ++i) {
      for (int j = -6; j <= 6; ++j) {
        for (int k = -6; k <= 6; ++k) {
          if (std::max({std::abs(i), std::abs(j), std::abs(k)}) == 4) continue;
          points.push_back(scale / 4 * Point(i, j, k));
          expected.push_back(std::max({std::abs(i), std::abs(j), std::abs(k)}) < 4 ? 1 : 0);
        }
      }
    }
    points.push_back(scale * Point(0.25, 0.5, 2));  // once where the predicates' range ends
    expected.push_back(0);
    const auto found = certify::winding_numbers(mesh, points);
    for (std::size_t p = 0; p < points.size(); ++p) CHECK(found[p] == expected[p]);
  }
}

TEST_CASE("nested cubes add up, and those that face inwards take off") {
  support::for_seeds(100, [&](unsigned seed) {
    support::Random random(seed);
    IndexedMesh mesh;
    struct Box {
      Point low, high;
      int sign;
    };
    std::vector<Box> boxes;
    for (int i = 0; i < 6; ++i) {
      const Point low(random.between(0, 2), random.between(0, 2), random.between(0, 2));
      const Point high =
          low + Point(random.between(0.1, 2), random.between(0.1, 2), random.between(0.1, 2));
      const bool faces_out = random.below(3) != 0;
      boxes.push_back({low, high, faces_out ? 1 : -1});
      mesh.append(cube(low, high, faces_out));
    }
    std::vector<Point> points;
    for (int i = 0; i < 40; ++i) {
      points.emplace_back(random.between(0, 4), random.between(0, 4), random.between(0, 4));
    }
    // Those below a corner of a box: no luck is needed.
    for (const Box& box : boxes) points.push_back(box.low - Point(0, 0, 0.05));
    const auto found = certify::winding_numbers(mesh, points);
    for (std::size_t p = 0; p < points.size(); ++p) {
      int sum = 0;
      for (const Box& box : boxes) {
        const bool is_in = (points[p].array() > box.low.array()).all() &&
                           (points[p].array() < box.high.array()).all();
        sum += is_in ? box.sign : 0;
      }
      CHECK(found[p] == sum);
    }
  });
}

TEST_CASE("what a mesh bounds is told by points that no path from it to the skin passes") {
  const skin::SkinSurface skin({support::ball(0, 0, 0, 1)});
  const IndexedMesh mesh = support::sphere_mesh(Point::Zero(), 1, 3);
  const auto objection = [&](std::vector<Point> inside, std::vector<Point> outside) {
    const surface::Topology expected{1, 0, 2, std::move(inside), std::move(outside)};
    return certify::certify(mesh, skin, expected).broken_by(certify::Claim::Counts);
  };
  const Point centre(0, 0, 0), away(0, 3, 0);
  CHECK(objection({centre}, {away}) == "");
  CHECK(support::contains(objection({centre, away}, {}), "should go once round (0, 3, 0)"));
  CHECK(support::contains(objection({centre}, {centre}), "should not go round (0, 0, 0)"));
  // Between a triangle and the skin: inside the skin, and the mesh does not go round it.
  for (const std::size_t t : {std::size_t{0}, std::size_t{77}, mesh.triangles.size() - 1}) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point foot = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    for (const double share : {0.1, 0.9}) {
      const Point between = foot.normalized() * (share + (1 - share) * foot.norm());
      CHECK(support::contains(objection({centre}, {between}), "a triangle is too near to"));
    }
  }
}

TEST_CASE("a point on a path is found however far it lies from the first corner of its triangle") {
  const skin::SkinSurface skin({support::ball(0, 0, 0, 1)});
  for (const double radius : {0.8, 0.99}) {
    const IndexedMesh mesh = support::sphere_mesh(Point::Zero(), radius, 3);
    for (std::uint32_t v = 0; v < mesh.positions.size(); v += 7) {
      IndexedMesh begun_elsewhere = mesh;
      for (auto& triangle : begun_elsewhere.triangles) {
        if (triangle[0] == v) std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
      }
      for (const double share : {0.1, 0.9}) {
        CAPTURE(radius);
        CAPTURE(v);
        CAPTURE(share);
        const Point on_path = mesh.positions[v] * ((1 - share) + share / radius);
        const surface::Topology expected{1, 0, 2, {Point::Zero()}, {on_path}};
        const auto certificate = certify::certify(begun_elsewhere, skin, expected);
        CHECK(support::contains(certificate.broken_by(certify::Claim::Counts),
                                "a triangle is too near to"));
      }
    }
  }
}
