#include "certify/covering_degree.h"

#include "geometry/mesh_shape.h"
#include "skin/skin_surface.h"
#include "tests/support/ball_sets.h"
#include "tests/support/rationals.h"
#include "tests/support/test.h"
#include "tests/support/wrong_meshes.h"

using namespace morskin;
using namespace morskin::certify;
using geometry::IndexedMesh;

namespace {

/// The longest path along which G changes by g from where |N| = n, and the change along it.
double path(double n, double g) { return n - std::sqrt(n * n - g); }
double change(double n, double path) { return (2 * n - path) * path; }

/// A mesh of a sphere about the origin, and perhaps a tetrahedron over its top, of which as much is
/// known as is said here. (c3) is tried at the top only.
class Top {
 public:
  /// @param levels  how often an octahedron is cut finer
  explicit Top(double radius, double error, int levels)
      : mesh_(support::begun_at(support::sphere_mesh(Point::Zero(), radius, levels), top)),
        first_of_tetrahedron_(mesh_.triangles.size()) {
    constexpr float unknown = 1;
    add_vertices({Vector::Zero(), 0, 0, unknown, geometry::CellId{0U}});
    vertices_[top].error = static_cast<float>(error);
  }

  void know_top(double g) { vertices_[top].high = static_cast<float>(g); }
  void know_others(double g) {
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (v != top) vertices_[v].high = static_cast<float>(g);
    }
  }
  /// A small tetrahedron whose nearest point to the top, and to the line through it, is a corner.
  void add_tetrahedron(const Point& corner, const Vector& from_corner, double g) {
    const Vector e = from_corner.unitOrthogonal(), f = from_corner.cross(e);
    IndexedMesh small;
    small.positions = {corner};
    for (const double turn : {0.0, 2 * M_PI / 3, 4 * M_PI / 3}) {
      small.positions.emplace_back(
          corner + size * (from_corner + 0.5 * (std::cos(turn) * e + std::sin(turn) * f)));
    }
    small.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
    mesh_ = support::together(mesh_, small);
    add_vertices({Vector::Zero(), 0, static_cast<float>(g), 0, geometry::CellId{0U}});
  }

  /// @param max_path, max_error  of the tetrahedron, as the triangles' bounds have it
  bool is_proved(double max_path = 0, double max_error = 0) const {
    const skin::SkinSurface skin({support::ball(0, 0, 0, 1)});
    const LocatedMesh located{mesh_, vertices_, skin};
    FlowBounds flow;
    for (std::size_t t = first_of_tetrahedron_; t < mesh_.triangles.size(); ++t) {
      const double rho = vertices_[mesh_.triangles[t][0]].length_scale();
      flow.add(static_cast<std::uint32_t>(t), located.shape(mesh_.triangles[t]).circumradius,
               max_path, rho, max_error);
    }
    const auto built = geometry::closed_triangles(mesh_.positions.size(), mesh_.triangles);
    REQUIRE_FALSE(built.defect);
    const auto components = geometry::vertex_components(mesh_);
    return CoveringDegree(located, built.mesh, components, flow).proved_vertices(2)[0].has_value();
  }

  static constexpr double size = 1e-3;

 private:
  /// What is known of the vertices that were added to the mesh. N is the position.
  void add_vertices(LocatedVertex known) {
    for (std::size_t v = vertices_.size(); v < mesh_.positions.size(); ++v) {
      known.half_gradient = mesh_.positions[v];
      vertices_.push_back(known);
    }
  }

  static constexpr std::uint32_t top = 4;
  IndexedMesh mesh_;
  std::size_t first_of_tetrahedron_;
  std::vector<LocatedVertex> vertices_;
};

/// An octahedron at the origin, so small that no path matters, whose first triangle at its top is a
/// needle: the third corner lies nearly on the line of the two others. N is the same all over.
struct Needle {
  explicit Needle(support::Random& random) {
    // On a grid on which products of coordinates are rounded by about as much as the needle is
    // wide.
    const double size = 0x1p48, width = std::exp2(random.between(0, 7));
    const auto on_grid = [](const Vector& x) { return Vector(x.array().round().matrix()); };
    const Vector along = on_grid(size * random.direction());
    const Vector off = on_grid(width * random.in_cube(-1, 1));
    const Vector across = along.cross(off).normalized(), out = along.cross(across).normalized();
    N = (out + 2 * std::pow(random.between(-1, 1), 3) / width * across).normalized();
    const Vector left = N.cross(along);
    positions = {Point::Zero(),
                 along,
                 2 * along + off,
                 on_grid(left - 0.5 * along),
                 on_grid(-left - 0.5 * along),
                 on_grid(-size * N)};
    for (Point& x : positions) x *= 0x1p-148;
  }

  bool is_proved() const {
    const IndexedMesh mesh{
        positions,
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {2, 1, 5}, {3, 2, 5}, {4, 3, 5}, {1, 4, 5}}};
    const std::vector<LocatedVertex> vertices(positions.size(), {N, 0, 0, 0, geometry::CellId{0U}});
    const skin::SkinSurface skin({support::ball(0, 0, 0, 1)});
    const LocatedMesh located{mesh, vertices, skin};
    const auto built = geometry::closed_triangles(positions.size(), mesh.triangles);
    REQUIRE_FALSE(built.defect);
    const auto components = geometry::vertex_components(mesh);
    return CoveringDegree(located, built.mesh, components, FlowBounds{}).proved_vertices()[0] ==
           VertexId{0U};
  }
  bool seems_upright() const { return N.dot(positions[1].cross(positions[2])) > 0; }
  bool is_upright() const {
    const auto a = support::rational::exact(positions[1]),
               b = support::rational::exact(positions[2]);
    const auto n = support::rational::exact(N);
    const mpq_class x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2],
                    z = a[0] * b[1] - a[1] * b[0];
    return n[0] * x + n[1] * y + n[2] * z > 0;
  }

  std::vector<Point> positions;
  Vector N;
};

/// Errors of N that leave a vertex a candidate.
constexpr std::array errors{0.0, 0.99 * FlowBounds::max_doubt};
constexpr double less = 1 - 1e-4, more = 1 + 1e-4;

}  // namespace

TEST_CASE("a vertex proves nothing if it is far off the skin, or N is in doubt there") {
  for (const double error : errors) {
    const double n = 1 - error, farthest = change(n, n / 16);
    for (const double share : {less, more}) {
      Top top(1, error, 1);
      top.know_top(share * farthest);
      CHECK(top.is_proved() == (share < 1));
    }
  }
  // rho falls by the error.
  constexpr double largest = FlowBounds::max_doubt / (1 + FlowBounds::max_doubt);
  CHECK(Top(1, less * largest, 1).is_proved());
  CHECK_FALSE(Top(1, more * largest, 1).is_proved());
}

TEST_CASE("a vertex is proved up to where a path from it may come back to its triangles' planes") {
  const double cosine = 1 / std::sqrt(3.0), squared_circumradius = 2.0 / 3;
  for (const double error : errors) {
    CAPTURE(error);
    const double farthest = change(1 - error, cosine - error) - squared_circumradius;
    for (const double at_top : {0.0, 0.05, 0.07}) {
      CAPTURE(at_top);
      for (const double share : {0.0, 0.9, less, more, 1.1}) {
        CAPTURE(share);
        Top octahedron(1, error, 0);
        octahedron.know_top(at_top);
        octahedron.know_others(share * farthest - at_top);
        CHECK(octahedron.is_proved() == (share < 1));
      }
    }
  }
}

TEST_CASE("a triangle over a vertex denies its proof as far as a path may lead to it") {
  constexpr double at_top = 0.1, there = 0.4;
  for (const double error : errors) {
    CAPTURE(error);
    const double height = path(1 - error, at_top + there);
    const double aside = height * (height / 2 + error);
    for (const double share : {0.5, 0.999, 1.001, 1.5}) {
      CAPTURE(share);
      Top above(1, error, 1), beside(1, error, 1);
      for (Top* top : {&above, &beside}) top->know_top(at_top);
      above.add_tetrahedron({0, 0, 1 + share * height}, {0, 0, 1}, there);
      CHECK(above.is_proved(height) == (share > 1));
      beside.add_tetrahedron({share * aside, 0, 1 + height / 2}, {1, 0, 0}, there);
      CHECK(beside.is_proved(height) == (share > 1));
    }
  }
}

TEST_CASE("a triangle is tested at a vertex if their two paths together are as long as it is far") {
  // Radial paths: that of a triangle under the skin, and that of a vertex above.
  for (const double radius : {1.0, 1.01, 1.06}) {
    for (const double under : {0.9, 0.95, 0.99}) {
      CAPTURE(radius);
      CAPTURE(under);
      Top top(radius, 0, 1);
      top.know_top(radius * radius - 1);
      top.add_tetrahedron({0, 0, under}, {0, 0, -1}, 1 - under * under);
      CHECK_FALSE(top.is_proved(1 - under));
      CHECK_FALSE(top.is_proved(1 - under, 2 * FlowBounds::max_doubt));  // a far one
    }
  }
}

TEST_CASE("no vertex is proved with a triangle that only seems upright, its normal being rounded") {
  std::size_t proved = 0, deceptive = 0;
  support::for_seeds(3000, [&](unsigned seed) {
    support::Random random(seed);
    const Needle needle(random);
    deceptive += needle.seems_upright() && !needle.is_upright();
    if (!needle.is_proved()) return;
    CHECK(needle.is_upright());
    ++proved;
  });
  CHECK(proved > 200);
  CHECK(deceptive > 30);  // the law was put to the test
}
