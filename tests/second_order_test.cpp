// Curved triangles: what is proved of them, and what they are good for.

#include "morskin/second_order.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "certify/curved_mesh.h"
#include "geometry/error.h"
#include "geometry/mesh_shape.h"
#include "tests/support/meshes.h"
#include "tests/support/molecules.h"

using namespace morskin;
using namespace morskin::support;
using certify::CurvedTriangle;
using certify::least_jacobian;
using geometry::Point;
using geometry::Vector;

namespace {

CurvedTriangle flat(const Point& a, const Point& b, const Point& c) {
  return {a, b, c, (a + b) / 2, (b + c) / 2, (c + a) / 2};
}

/// Random corners, with nodes off the middles by up to `share` of the unit.
CurvedTriangle random_triangle(Random& random, double share) {
  const auto vector = [&]() -> Vector { return random.in_cube(-1, 1); };
  const Point a = vector(), b = vector(), c = vector();
  CurvedTriangle nodes = flat(a, b, c);
  for (std::size_t k = 3; k < 6; ++k) nodes[k] += share * vector();
  return nodes;
}

Point point_of(const CurvedTriangle& nodes, double u, double v) {
  const std::array<double, 3> l{1 - u - v, u, v};
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    sum += l[i] * (2 * l[i] - 1) * nodes[i] + 4 * l[i] * l[(i + 1) % 3] * nodes[3 + i];
  }
  return sum;
}

/// x_u x x_v, by differences of the interpolation itself.
Vector sampled_normal(const CurvedTriangle& nodes, double u, double v) {
  constexpr double h = 0x1p-10;  // central differences of a quadratic are exact
  const Vector by_u = (point_of(nodes, u + h, v) - point_of(nodes, u - h, v)) / (2 * h);
  const Vector by_v = (point_of(nodes, u, v + h) - point_of(nodes, u, v - h)) / (2 * h);
  return by_u.cross(by_v);
}

PreparedSkin ball(double radius) { return prepare_skin({{Point(1, 2, 3), 2 * radius * radius}}); }

/// The same with the nodes where the middles of the edges lead.
SecondOrder centered(SecondOrder curved, const surface::Surface& skin) {
  auto& [nodes, triangles] = curved.mesh;
  for (const geometry::SecondOrderTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point middle = (nodes[t[k]] + nodes[t[(k + 1) % 3]]) / 2;
      nodes[t[3 + k]] = skin.project(middle, curved.cells[t[k]]).value().position;
    }
  }
  return curved;
}

/// From the skin, over the points of a grid on every triangle.
double mean_distance(const SecondOrder& curved, const surface::Surface& skin) {
  constexpr int grid = 8;
  double sum = 0;
  std::size_t points = 0;
  for (const geometry::SecondOrderTriangle& t : curved.mesh.triangles) {
    const CurvedTriangle nodes = certify::nodes_of(curved.mesh, t);
    for (int i = 0; i <= grid; ++i) {
      for (int j = 0; i + j <= grid; ++j, ++points) {
        const Point x =
            point_of(nodes, static_cast<double>(i) / grid, static_cast<double>(j) / grid);
        sum += (skin.project(x, curved.cells[t[0]]).value().position - x).norm();
      }
    }
  }
  return sum / static_cast<double>(points);
}

MeshResult coarse(const PreparedSkin& skin, double C) {
  return make_mesh(skin, {.sizing = sizing_for(C), .has_safety_net = false});
}

}  // namespace

TEST_CASE("a flat triangle has the Jacobian 1 everywhere, and its own area") {
  const CurvedTriangle nodes = flat({0, 0, 0}, {3, 0, 0}, {0, 4, 0});
  CHECK(least_jacobian(nodes).value() == doctest::Approx(1).epsilon(1e-14));
  CHECK(certify::curved_area(nodes) == doctest::Approx(6).epsilon(1e-14));
}

TEST_CASE("what is proved is a lower bound of the Jacobian at every point sampled") {
  Random random(3);
  std::size_t proved = 0, refused = 0;
  for (int k = 0; k < 20'000; ++k) {
    CAPTURE(k);
    const CurvedTriangle nodes = random_triangle(random, 0.2);
    const Vector d = (nodes[1] - nodes[0]).cross(nodes[2] - nodes[0]);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; i + j <= 8; ++j) {
        const double normal = sampled_normal(nodes, i / 8.0, j / 8.0).dot(d) / d.squaredNorm();
        least = std::min(least, normal);
      }
    }
    const std::optional<double> bound = least_jacobian(nodes);
    if (bound) CHECK(*bound <= least + 1e-6 * (1 + std::abs(least)));
    if (least <= -1e-6) CHECK(!bound);
    ++(bound ? proved : refused);
  }
  CHECK(proved > 2000);
  CHECK(refused > 2000);
}

TEST_CASE("a triangle that folds over, is flat to a line or holds no numbers is not proved") {
  CurvedTriangle folded = flat({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  folded[3] = Point(0.9, 0, 0);  // beyond the quarter, where x_u vanishes at b
  CHECK(!least_jacobian(folded));
  folded[3] = Point(0.75, 0, 0);  // at it
  CHECK(!least_jacobian(folded));
  folded[3] = Point(0.74, 0, 0);
  CHECK(least_jacobian(folded));
  CHECK(!least_jacobian(flat({0, 0, 0}, {1, 1, 1}, {2, 2, 2})));
  CHECK(!least_jacobian(flat({1, 1, 1}, {1, 1, 1}, {1, 1, 1})));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
    CurvedTriangle nodes = flat({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    nodes[4].z() = bad;
    CHECK(!least_jacobian(nodes));
  }
}

TEST_CASE("the verdict is the same however large the triangle, and wherever it lies") {
  Random random(5);
  for (int k = 0; k < 2000; ++k) {
    const CurvedTriangle nodes = random_triangle(random, 0.2);
    const auto bound = least_jacobian(nodes);
    for (const double factor : {0x1p-60, 0x1p40}) {
      CurvedTriangle scaled = nodes;
      for (Point& p : scaled) p *= factor;
      CHECK(least_jacobian(scaled) == bound);
    }
  }
  // Far out the nodes are rounded, and what is proved is of the rounded ones.
  CurvedTriangle far = flat({1e15, 0, 0}, {1e15 + 2, 0, 0}, {1e15, 2, 0});
  CHECK(least_jacobian(far).value() == doctest::Approx(1));
}

TEST_CASE("every node lies on the skin, and two triangles share the one of their edge") {
  for_skins(30, [](const PreparedSkin& skin) {
    const MeshResult made = coarse(skin, 0.2);
    if (!made.certificate.certified) return;
    const SecondOrder curved = second_order(skin.surface, made.mesh, made.cells);
    const auto vertices = made.mesh.positions.size();
    CHECK(curved.mesh.nodes.size() == vertices + made.mesh.triangles.size() * 3 / 2);
    CHECK(curved.cells.size() == curved.mesh.nodes.size());
    std::vector<int> uses(curved.mesh.nodes.size(), 0);
    for (std::size_t t = 0; t < curved.mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(curved.mesh.triangles[t][k] == made.mesh.triangles[t][k]);
        ++uses[curved.mesh.triangles[t][3 + k]];
      }
    }
    for (std::size_t v = vertices; v < uses.size(); ++v) {
      CHECK(uses[v] == 2);
      const auto jet = skin.surface.jet(curved.mesh.nodes[v], curved.cells[v]);
      CHECK(std::abs(jet.value) <= skin.surface.residual_bound(jet.half_gradient.norm()));
    }
    CHECK(curved.measures.least_jacobian > 0.3);
  });
}

TEST_CASE(
    "on a ball a curved mesh is off by less than the square of the share that a flat one lacks") {
  const double radius = 2, exact = 4 * M_PI * radius * radius;
  const PreparedSkin skin = ball(radius);
  for (const double C : {0.35, 0.2, 0.1, 0.05}) {
    CAPTURE(C);
    const MeshResult made = coarse(skin, C);
    const double lacking = 1 - geometry::measure_shape(made.mesh).area / exact;
    const SecondOrder curved = second_order(skin.surface, made.mesh, made.cells);
    CHECK(lacking > 0);
    CHECK(std::abs(1 - curved.measures.area / exact) < lacking * lacking);
  }
}

TEST_CASE("nodes that do not fit the edges are objected to") {
  // Two triangles back to back, in the plane.
  const geometry::SecondOrderMesh good{
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
      {{0, 1, 2, 3, 4, 5}, {0, 2, 1, 5, 4, 3}}};
  CHECK(certify::objection_to_nodes(good).empty());
  CHECK(certify::objection_to_nodes({}).empty());
  geometry::SecondOrderMesh cracked = good;
  cracked.nodes.emplace_back(1, 0, 0);
  cracked.triangles[1][5] = 6;
  CHECK(certify::objection_to_nodes(cracked) ==
        "the edge between the vertices 0 and 1 has the nodes 3 and 6");
  geometry::SecondOrderMesh shared = good;
  shared.nodes[3] = {0.5, 0.5, 0};
  for (const auto& [t, k] : {std::pair(0, 5), std::pair(1, 3)}) shared.triangles[t][k] = 3;
  CHECK(certify::objection_to_nodes(shared) ==
        "node 3 lies in the edge between the vertices 0 and 1 and in the edge between the "
        "vertices 0 and 2");
  geometry::SecondOrderMesh far = good;
  far.nodes[4] = {1, 1, 1.4};
  CHECK(certify::objection_to_nodes(far).empty());
  for (const double height : {1.42, 100.}) {
    far.nodes[4] = {1, 1, height};
    CHECK(certify::objection_to_nodes(far) ==
          "node 4 is no nearer to the middle of the edge between the vertices 1 and 2 than they "
          "are");
  }
}

TEST_CASE("on a ball the node is where the middle leads") {
  const PreparedSkin skin = ball(2);
  const MeshResult made = coarse(skin, 0.2);
  const SecondOrder curved = second_order(skin.surface, made.mesh, made.cells);
  for (const geometry::SecondOrderTriangle& t : curved.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto along = [&](std::uint32_t node) -> Vector {
        return (curved.mesh.nodes[node] - Point(1, 2, 3)) / 2;
      };
      const Vector middle = (along(t[k]) + along(t[(k + 1) % 3])).normalized();
      CHECK((along(t[3 + k]) - middle).norm() < 1e-10);
    }
  }
}

TEST_CASE("nodes of the parabola bring triangles nearer to the skin than those of the middles") {
  for (const char* file : {"benzene.pdb", "caffeine.xyz", "ring12.xyzr"}) {
    CAPTURE(file);
    const PreparedSkin skin = prepare_skin(molecule(file, skin::Model::Vdw));
    for (const double C : {0.35, 0.2}) {
      CAPTURE(C);
      const MeshResult made = coarse(skin, C);
      const SecondOrder curved = second_order(skin.surface, made.mesh, made.cells);
      const SecondOrder middles = centered(curved, skin.surface);
      CHECK(mean_distance(curved, skin.surface) < 0.95 * mean_distance(middles, skin.surface));
      CHECK(curved.measures.least_jacobian > 0);
    }
  }
}

TEST_CASE("a triangle that would fold over is refused and named") {
  const PreparedSkin skin = ball(1);
  // The middle of the long edge moves out to the arc, nearly as far as the third corner.
  const Point centre(1, 2, 3);
  const double wide = 70 * M_PI / 180, narrow = 5 * M_PI / 180;
  const geometry::IndexedMesh mesh{{centre + Point(std::cos(wide), std::sin(wide), 0),
                                    centre + Point(std::cos(wide), -std::sin(wide), 0),
                                    centre + Point(std::cos(narrow), 0, std::sin(narrow))},
                                   {{0, 1, 2}, {0, 2, 1}}};
  const std::vector<geometry::CellId> cells(
      3, skin.surface.locate(mesh.positions[0], geometry::CellId{}));
  CHECK_THROWS_WITH_AS(second_order(skin.surface, mesh, cells),
                       doctest::Contains("second-order triangle 0, with corners 0, 1 and 2"),
                       geometry::RefusedInput);
}
