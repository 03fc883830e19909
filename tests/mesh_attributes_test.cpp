// What is told of the skin beside the mesh: against differences, sums and searches over all atoms.

#include "morskin/mesh_attributes.h"

#include <cstring>
#include <map>
#include <numeric>
#include <ranges>
#include <set>
#include <sstream>
#include <string_view>

#include "geometry/files/mesh_files.h"
#include "geometry/mesh_shape.h"
#include "skin/atom_shares.h"
#include "skin/curvatures.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;
using geometry::IndexedMesh;
using geometry::MeshAttributes;
using geometry::MeshFormat;
using geometry::Point;
using geometry::Vector;
using surface::SurfacePoint;

namespace {

MeshResult meshed_with(const PreparedSkin& skin, double C) {
  return make_mesh(skin, {.sizing = sizing_for(C), .angle_goal_deg = 0, .has_safety_net = false});
}

/// Calls check(skin, mesh, point) at some vertices of meshes of several skins.
template <class Check>
void for_vertices(unsigned skins, Check check) {
  for_skins(skins, [&](const PreparedSkin& skin) {
    const MeshResult made = meshed_with(skin, 0.2);
    for (std::size_t v = 0; v < made.mesh.positions.size(); v += 7) {
      check(skin, made.mesh, skin.surface.at(made.mesh.positions[v], made.cells[v]));
    }
  });
}

const geometry::Attribute& named(const std::vector<geometry::Attribute>& all,
                                 std::string_view name) {
  const auto found = std::ranges::find(all, name, &geometry::Attribute::name);
  REQUIRE(found != all.end());
  return *found;
}

MeshAttributes all_of(const PreparedSkin& skin, const MeshResult& made) {
  return mesh_attributes(skin.surface, made.mesh, made.cells, all_data());
}

}  // namespace

TEST_CASE(
    "the normal turns by a principal curvature along its direction, and about no other axis") {
  std::size_t umbilics = 0, others = 0;
  for_vertices(40, [&](const PreparedSkin& skin, const IndexedMesh&, const SurfacePoint& x) {
    const skin::Patch patch = skin.surface.patch(x.cell);
    const skin::Curvatures k = skin::curvatures(patch, x);
    const Vector &first = k.directions[0], &second = k.directions[1];
    CHECK(k.principal[0] >= k.principal[1]);
    CHECK(std::abs(first.norm() - 1) < 1e-12);
    CHECK(std::abs(first.dot(x.normal)) < 1e-12);
    CHECK((first.cross(second) - x.normal).norm() < 1e-12);
    CHECK(std::max(std::abs(k.principal[0]), std::abs(k.principal[1])) * x.length_scale ==
          doctest::Approx(1));
    const double step = 1e-4 * x.length_scale;
    for (std::size_t i = 0; i < 2; ++i) {
      const Point ahead = patch.slide(x.position + step * k.directions[i]);
      const Point behind = patch.slide(x.position - step * k.directions[i]);
      const Vector turn = (patch.normal(ahead) - patch.normal(behind)) / (2 * step);
      CHECK((turn - k.principal[i] * k.directions[i]).norm() * x.length_scale < 1e-6);
    }
    (k.principal[0] == k.principal[1] ? umbilics : others) += 1;
  });
  CHECK(umbilics > 500);
  CHECK(others > 500);
}

TEST_CASE(
    "shape index, curvedness, mean and Gaussian curvature say of a bump, a pit and a saddle") {
  const auto of = [](double k1, double k2) { return skin::Curvatures{{k1, k2}, {}}; };
  CHECK(of(0.5, 0.5).shape_index() == doctest::Approx(1));
  CHECK(of(-0.5, -0.5).shape_index() == doctest::Approx(-1));
  CHECK(of(0.5, -0.5).shape_index() == doctest::Approx(0));
  CHECK(of(0.5, 0).shape_index() == doctest::Approx(0.5));
  CHECK(of(0.5, 0.5).curvedness() == doctest::Approx(0.5));
  CHECK(of(0.5, -0.25).mean() == doctest::Approx(0.125));
  CHECK(of(0.5, -0.25).gaussian() == doctest::Approx(-0.125));
}

TEST_CASE("the shares of a mixed cell's atoms give back x - N, and add up to 1") {
  std::array<std::size_t, 5> by_size{};
  for_vertices(40, [&](const PreparedSkin& skin, const IndexedMesh&, const SurfacePoint& x) {
    const skin::AtomShares shares = skin::atom_shares(skin.surface, x);
    Point mean = Point::Zero();
    double sum = 0;
    for (std::size_t i = 0; i < shares.size; ++i) {
      CHECK(shares.shares[i] >= 0);
      mean += shares.shares[i] * skin.surface.points()[shares.atoms[i].index()].position;
      sum += shares.shares[i];
    }
    CHECK(std::abs(sum - 1) < 1e-12);
    const Point expected = x.position - x.length_scale * x.normal;
    CHECK((mean - expected).norm() <= 1e-7 * (1 + expected.norm()));
    ++by_size[shares.size];
  });
  for (std::size_t size = 1; size <= 4; ++size) CHECK(by_size[size] > 0);
}

TEST_CASE("no atom is nearer by power distance than the nearest") {
  for_vertices(60, [&](const PreparedSkin& skin, const IndexedMesh&, const SurfacePoint& x) {
    const auto power = [&](const geometry::WeightedPoint& p) {
      return (x.position - p.position).squaredNorm() - p.weight;
    };
    const auto& points = skin.surface.points();
    const geometry::AtomId nearest = skin.surface.nearest_atom(x.position, x.cell);
    CHECK(power(points[nearest.index()]) == power(*std::ranges::min_element(points, {}, power)));
  });
}

TEST_CASE("the areas of atoms add up to the mesh's; balls far apart have their own") {
  for_skins(20, [&](const PreparedSkin& skin) {
    const MeshResult made = meshed_with(skin, 0.2);
    const std::vector<double> areas = areas_of_atoms(skin.surface, made.mesh, made.cells);
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    CHECK(sum == doctest::Approx(geometry::measure_shape(made.mesh).area).epsilon(1e-12));
  });
  const PreparedSkin apart = prepare_skin({ball(0, 0, 0, 1), ball(10, 0, 0, 2)});
  const MeshResult made = meshed_with(apart, 0.08);
  const std::vector<double> areas = areas_of_atoms(apart.surface, made.mesh, made.cells);
  CHECK(areas[0] == doctest::Approx(4 * M_PI).epsilon(0.01));
  CHECK(areas[1] == doctest::Approx(16 * M_PI).epsilon(0.01));
}

TEST_CASE("Gaussian curvature over a mesh adds up to 2 pi chi, and the error halves with C") {
  // K jumps between patches, so over a triangle across a border it is wrong by as much as itself:
  // a strip along all borders, as wide as a triangle.
  double coarse = 0, fine = 0;
  for_skins(20, [&](const PreparedSkin& skin) {
    const auto error = [&](double C) {
      const MeshResult made = meshed_with(skin, C);
      const MeshAttributes told = all_of(skin, made);
      const geometry::Attribute& curvature = named(told.vertices, "curvature");
      double sum = 0, size = 0;
      for (const auto& [a, b, c] : made.mesh.triangles) {
        const Vector ab = made.mesh.positions[b] - made.mesh.positions[a];
        const double area = ab.cross(made.mesh.positions[c] - made.mesh.positions[a]).norm() / 2;
        for (const std::uint32_t v : {a, b, c}) {
          const double K = curvature.numbers[6 * v + 3];
          sum += area / 3 * K;
          size += area / 3 * std::abs(K);
        }
      }
      const double off =
          std::abs(sum - 2 * M_PI * static_cast<double>(made.certificate.euler_characteristic));
      CHECK(off <= C * size);
      return off;
    };
    coarse += error(0.16);
    fine += error(0.04);
  });
  CHECK(fine < coarse / 4);
}

TEST_CASE("the wall of a void is told from an outer surface, and components count from 0") {
  const PreparedSkin skin = prepare_skin(molecule("shell_hollow.xyzr", skin::Model::Sas));
  const MeshResult made = meshed_with(skin, 0.2);
  const MeshAttributes told = all_of(skin, made);
  const geometry::Attribute& component = named(told.vertices, "component");
  std::set<std::pair<double, double>> found;
  for (std::size_t v = 0; v < made.mesh.positions.size(); ++v) {
    found.emplace(component.numbers[2 * v], component.numbers[2 * v + 1]);
  }
  REQUIRE(found.size() == 2);
  CHECK(found.begin()->first == 0);
  CHECK(std::next(found.begin())->first == 1);
  CHECK(found.begin()->second + std::next(found.begin())->second == 1);
  CHECK(named(told.triangles, "component").numbers.size() == 2 * made.mesh.triangles.size());
}

TEST_CASE("a body inside a void has a component that encloses no void") {
  WeightedPoints balls = molecule("shell_hollow.xyzr", skin::Model::Vdw);
  balls.push_back(ball(0, 0, 0, 1));
  const PreparedSkin skin = prepare_skin(balls);
  REQUIRE(skin.topology.voids.size() == 1);
  REQUIRE(skin.topology.voids[0].bodies.size() == 2);
  const MeshResult made = meshed_with(skin, 0.2);
  const geometry::Attribute component = named(all_of(skin, made).vertices, "component");
  std::map<double, double> is_void;  // by component
  for (std::size_t v = 0; v < made.mesh.positions.size(); ++v) {
    is_void[component.numbers[2 * v]] = component.numbers[2 * v + 1];
    const bool is_inner = made.mesh.positions[v].norm() < 2;
    if (is_inner) CHECK(component.numbers[2 * v + 1] == 0);
  }
  REQUIRE(is_void.size() == 3);
  CHECK(is_void[0] + is_void[1] + is_void[2] == 1);
}

TEST_CASE(
    "a property of atoms that is the same for all is the same everywhere, however it is told") {
  for_skins(10, [&](const PreparedSkin& skin) {
    const MeshResult made = meshed_with(skin, 0.2);
    const std::vector<double> same(skin.surface.points().size(), 3);
    const std::vector<AtomProperty> properties{{"nearest", same, false}, {"between", same, true}};
    const MeshAttributes told =
        mesh_attributes(skin.surface, made.mesh, made.cells, {}, properties);
    REQUIRE(told.vertices.size() == properties.size());
    for (const geometry::Attribute& a : told.vertices) {
      CHECK(a.numbers.size() == made.mesh.positions.size());
      for (const double number : a.numbers) CHECK(number == doctest::Approx(3).epsilon(1e-14));
    }
  });
}

TEST_CASE("a PLY file with all that can be told holds the same mesh, and the numbers in its rows") {
  const PreparedSkin skin = prepare_skin(molecule("caffeine.xyz", skin::Model::Vdw));
  const MeshResult made = meshed_with(skin, 0.2);
  const MeshAttributes told = all_of(skin, made);
  const std::string bytes = geometry::serialized(made.mesh, MeshFormat::PlyBinary, told);
  CHECK(geometry::parse_mesh(bytes, "all.ply") == made.mesh);
  const std::size_t body = bytes.find("end_header\n") + 11;
  std::size_t row = 3 * sizeof(double);
  for (const geometry::Attribute& a : told.vertices) {
    for (const std::string& column : a.columns) {
      CHECK(bytes.find((a.is_whole ? "property int " : "property double ") + column + "\n") < body);
    }
    row += a.columns.size() * (a.is_whole ? sizeof(std::int32_t) : sizeof(double));
  }
  const geometry::Attribute& normal = named(told.vertices, "normal");
  for (std::size_t v = 0; v < made.mesh.positions.size(); ++v) {
    Vector stored;  // the first attribute
    std::memcpy(stored.data(), bytes.data() + body + v * row + 3 * sizeof(double), sizeof stored);
    CHECK(stored == Vector(normal.numbers.data() + 3 * v));
    CHECK(std::abs(stored.norm() - 1) < 1e-12);
  }
}

TEST_CASE("MSMS's two files hold every coordinate to the last bit, and the atoms from 1 on") {
  const PreparedSkin skin = prepare_skin(molecule("caffeine.xyz", skin::Model::Vdw));
  const MeshResult made = meshed_with(skin, 0.2);
  MeshAttributes told;
  told.msms = msms_columns(skin.surface, made.mesh, made.cells);
  told.normals = skin_normals(skin.surface, made.mesh, made.cells);
  const std::string vertices = geometry::serialized(made.mesh, MeshFormat::MsmsVertices, told);
  const std::string faces = geometry::serialized(made.mesh, MeshFormat::MsmsFaces, told);
  CHECK(geometry::parse_msms(vertices, "x.vert", faces, "x.face") == made.mesh);
  std::istringstream lines(vertices);
  std::string line;
  for (int header = 0; header < 3; ++header) std::getline(lines, line);
  std::set<int> spheres;
  for (std::size_t v = 0; std::getline(lines, line); ++v) {
    std::istringstream fields(line);
    double x = 0, y = 0, z = 0;
    Vector normal;
    int zero = -1, sphere = 0, kind = 0;
    fields >> x >> y >> z >> normal.x() >> normal.y() >> normal.z() >> zero >> sphere >> kind;
    REQUIRE(!fields.fail());
    CHECK(zero == 0);
    CHECK((kind >= 1 && kind <= 3));
    CHECK(std::abs(normal.norm() - 1) < 1e-12);
    spheres.insert(sphere);
  }
  CHECK(*spheres.begin() >= 1);
  CHECK(*spheres.rbegin() <= static_cast<int>(skin.surface.points().size()));
}
