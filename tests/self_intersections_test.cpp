#include "geometry/self_intersections.h"

#include "geometry/predicates.h"
#include "geometry/triangle_contact.h"
#include "tests/support/meshes.h"

using namespace morskin;
using geometry::IndexedMesh;
using geometry::Point;
using geometry::SelfIntersections;
using support::Random;

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs all_pairs(const IndexedMesh& mesh) {
  const geometry::ExactPositions at(mesh.positions);
  const auto is_whole = [&](const auto& t) {
    return !geometry::repeats_a_corner(t) && !geometry::are_collinear(at[t[0]], at[t[1]], at[t[2]]);
  };
  Pairs pairs;
  for (std::uint32_t s = 0; s < mesh.triangles.size(); ++s) {
    for (std::uint32_t t = s + 1; t < mesh.triangles.size(); ++t) {
      const auto &a = mesh.triangles[s], &b = mesh.triangles[t];
      if (is_whole(a) && is_whole(b) && is_improper_contact(at, a, b)) pairs.emplace_back(s, t);
    }
  }
  return pairs;
}

void check_against_all_pairs(const IndexedMesh& mesh) {
  const Pairs expected = all_pairs(mesh);
  const SelfIntersections found = self_intersections(mesh, {100000, 100000});
  CHECK(found.count == expected.size());
  CHECK(found.pairs == expected);
  CHECK(found.is_complete);
}

IndexedMesh soup(unsigned seed) {
  Random random(seed);
  IndexedMesh mesh;
  const std::size_t vertices = 5 + random.below(60);
  const bool is_lattice = seed % 2 == 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    Point p(random.between(0, 6), random.between(0, 6), random.between(0, 6));
    if (is_lattice) p = p.array().floor().matrix();
    mesh.positions.push_back(p);
  }
  for (std::size_t t = 0; t < 2 * vertices; ++t) {
    const auto corner = [&] { return static_cast<std::uint32_t>(random.below(vertices)); };
    mesh.triangles.push_back({corner(), corner(), corner()});
  }
  return mesh;
}

// Triangles that crowd about two hubs, of few corners: with folds, copies, and many contacts.
IndexedMesh crowded_soup(unsigned seed) {
  Random random(seed);
  IndexedMesh mesh = soup(seed);
  mesh.positions.resize(std::min<std::size_t>(mesh.positions.size(), 6 + seed % 30));
  mesh.triangles.clear();
  for (std::size_t t = 0; t < 250; ++t) {
    const auto corner = [&] {
      return static_cast<std::uint32_t>(random.below(mesh.positions.size()));
    };
    const std::uint32_t hub = t % 3 == 0 ? 0 : 1;
    mesh.triangles.push_back({corner(), t % 5 == 0 ? corner() : hub, t % 2 == 0 ? 2 : corner()});
  }
  return mesh;
}

constexpr std::uint32_t many = 100000;

// Many points on a circle about the z axis, after the two on the axis.
IndexedMesh circle() {
  IndexedMesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}};
  for (std::uint32_t i = 0; i < many; ++i) {
    const double azimuth = 2 * M_PI * i / many;
    mesh.positions.push_back({std::cos(azimuth), std::sin(azimuth), 0});
  }
  return mesh;
}

}  // namespace

TEST_CASE("the tree finds the pairs that asking all pairs finds, degenerate triangles among them") {
  support::for_seeds(300, [&](unsigned seed) { check_against_all_pairs(soup(seed)); });
}

TEST_CASE("about crowded corners and edges the pairs are those that asking all pairs finds") {
  support::for_seeds(60, [&](unsigned seed) { check_against_all_pairs(crowded_soup(seed)); });
}

TEST_CASE("a hundred thousand triangles about one edge, or one corner, are searched in no time") {
  IndexedMesh fan = circle(), star = circle();
  for (std::uint32_t i = 0; i < many; ++i) {
    fan.triangles.push_back({0, 1, i + 2});
    star.triangles.push_back({0, i + 2, (i + 1) % many + 2});
  }
  for (IndexedMesh* mesh : {&fan, &star}) {
    CHECK(geometry::self_intersections(*mesh).count == 0);
    // One more triangle, whose last corner is beside that of another.
    mesh->positions.push_back(mesh->positions[99] / 2);
    mesh->triangles.push_back({0, mesh == &fan ? 1U : 100U, many + 2});
    const SelfIntersections found = geometry::self_intersections(*mesh);
    // The star has a neighbour on whose edge that corner lies.
    CHECK(found.count == (mesh == &fan ? 1 : 2));
    CHECK(found.pairs[0].second == many);
  }
}

TEST_CASE("of the same triangle a hundred thousand times as many pairs are counted as are asked") {
  const IndexedMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  IndexedMesh shared = one, apart;
  for (std::uint32_t i = 0; i < many; ++i) {
    shared.triangles.push_back({0, 1, 2});
    apart.append({one.positions, {{0, 1, 2}}});
  }
  for (const IndexedMesh* mesh : {&shared, &apart}) {
    const SelfIntersections found = geometry::self_intersections(*mesh, {5, 1000});
    CHECK(found.count == 1000);
    CHECK_FALSE(found.is_complete);
    CHECK(found.pairs == geometry::self_intersections(*mesh, {5, 1000}).pairs);
  }
}

TEST_CASE("thousands of large boxes one in the other, upright or tilted, do not meet") {
  for (const double tilt : {0.0, 0.3}) {
    CAPTURE(tilt);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(tilt, Point(1, 2, 3).normalized()).toRotationMatrix();
    IndexedMesh mesh;
    for (std::uint32_t box = 0; box < 5000; ++box) {
      const std::uint32_t first = 8 * box;
      for (std::uint32_t i = 0; i < 8; ++i) {
        const Point corner(i & 4U ? 1 : -1, i & 2U ? 1 : -1, i & 1U ? 1 : -1);
        mesh.positions.push_back((1 + box * 1e-3) * (turn * corner));
      }
      for (const auto& [a, b, c, d] : {std::array{0U, 2U, 3U, 1U},
                                       {4U, 5U, 7U, 6U},
                                       {0U, 1U, 5U, 4U},
                                       {2U, 6U, 7U, 3U},
                                       {0U, 4U, 6U, 2U},
                                       {1U, 3U, 7U, 5U}}) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.triangles.push_back({first + a, first + c, first + d});
      }
    }
    CHECK(geometry::self_intersections(mesh).count == 0);
  }
}

TEST_CASE("meshes of a few triangles or none are searched") {
  CHECK(geometry::self_intersections({}).count == 0);
  IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  CHECK(geometry::self_intersections(mesh).count == 0);
  mesh.triangles.push_back({1, 0, 2});
  CHECK(geometry::self_intersections(mesh).pairs == Pairs{{0, 1}});
  mesh.triangles = {{0, 0, 1}, {2, 2, 2}};
  CHECK(geometry::self_intersections(mesh).count == 0);
}

TEST_CASE("a sphere's mesh has no self-intersection, wherever it is and however small or large") {
  for (const double scale : {1.0, 0x1p-900, 0x1p900, 1e-30}) {
    CAPTURE(scale);
    IndexedMesh mesh = support::sphere_mesh({0, 0, 0}, 1, 3);
    for (Point& p : mesh.positions) p *= scale;
    CHECK(geometry::self_intersections(mesh).count == 0);
  }
}

TEST_CASE("two spheres that cross, touch in a point or stand apart are told from each other") {
  const IndexedMesh left = support::sphere_mesh({0, 0, 0}, 1, 3);
  for (const double x : {1.5, 2.0, std::nextafter(2.0, 3.0), 2.5}) {
    CAPTURE(x);
    // Octahedra's corners lie on the axes, so at distance 2 two vertices coincide.
    const IndexedMesh right = support::sphere_mesh({x, 0, 0}, 1, 3);
    IndexedMesh both = left;
    both.append(right);
    const SelfIntersections found = geometry::self_intersections(both);
    CHECK((found.count > 0) == (x <= 2.0));
    if (x == 2.0) CHECK(found.count == 16);  // four triangles round each of the two corners
    if (x < 2.0) check_against_all_pairs(both);
  }
}

TEST_CASE("a vertex pushed through the far side of its sphere crosses it there") {
  IndexedMesh mesh = support::sphere_mesh({0, 0, 0}, 1, 2);
  mesh.positions[0] = {-1.2, 0.01, 0.02};
  check_against_all_pairs(mesh);
  CHECK(geometry::self_intersections(mesh).count > 0);
}

TEST_CASE("a fold flat onto the neighbouring triangle is found") {
  const IndexedMesh mesh{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0.5, 0}, {1, -1, 0}},
                         {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}};
  CHECK(geometry::self_intersections(mesh).pairs == Pairs{{0, 1}});
}

TEST_CASE("the list keeps the first pairs and the search ends at its limit") {
  const IndexedMesh mesh = soup(7);
  const Pairs all = all_pairs(mesh);
  REQUIRE(all.size() > 20);
  const SelfIntersections few = geometry::self_intersections(mesh, {5, 100000});
  CHECK(few.count == all.size());
  CHECK(few.pairs == Pairs(all.begin(), all.begin() + 5));
  const SelfIntersections cut = geometry::self_intersections(mesh, {5, 10});
  CHECK(cut.count == 10);
  CHECK_FALSE(cut.is_complete);
}
