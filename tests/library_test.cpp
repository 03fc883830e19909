// The library's face, as its users see it: only what is installed and the standard library.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "morskin/features.h"
#include "morskin/morskin.h"
#include "tests/support/library_errors.h"
#include "tests/support/temporary_folder.h"

using morskin::Atom;
using morskin::Error;
using morskin::MeshOptions;
using morskin::Point;
using morskin::Skin;
using morskin::SkinMesh;
using morskin::SkinPoint;
using morskin::support::kind_of;

namespace {

constexpr morskin::SkinOptions balls{.model = morskin::Model::Vdw};

/// Two balls that make one piece, and one by itself.
const std::vector<Atom> three_atoms{{{0, 0, 0}, 1.5}, {{2, 0.3, 0}, 1.2}, {{40, 0, 0}, 2}};

Point operator-(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
double dot(const Point& p, const Point& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

}  // namespace

TEST_CASE("a bundled molecule is read, meshed and certified, and its files hold the same mesh") {
  const morskin::support::TemporaryFolder folder;
  const auto atoms = morskin::read_molecule("bench/molecules/caffeine.xyz");
  CHECK(atoms.size() == 24);
  const SkinMesh mesh = Skin(atoms).mesh();
  CHECK_MESSAGE(mesh.certificate().certified, mesh.certificate().reason);
  CHECK(mesh.certificate().min_angle_deg > 29.9);
  CHECK(mesh.certificate().components == mesh.skin().components());
  CHECK(mesh.certificate().genus == static_cast<long>(mesh.skin().genus()));
  CHECK(mesh.fallbacks().empty());
  for (const char* name : {"a.ply", "a.off", "a.obj"}) {
    morskin::write_mesh(mesh.triangles(), folder / name);
    const morskin::TriangleMesh read = morskin::read_mesh(folder / name);
    CHECK(read.vertices == mesh.triangles().vertices);
    CHECK(read.triangles == mesh.triangles().triangles);
    CHECK(mesh.skin().certify(read).certified);
  }
}

TEST_CASE("a skin without its voids is meshed and certified without them") {
  const auto atoms = morskin::read_molecule("bench/molecules/shell_hollow.xyzr");
  constexpr double all = std::numeric_limits<double>::infinity();
  const Skin whole(atoms), filled(atoms, {.drop_voids_below = all}),
      same(atoms, {.drop_voids_below = 1});
  CHECK(whole.components() == 2);
  CHECK(filled.components() == 1);
  CHECK(same.components() == 2);
  const SkinMesh mesh = filled.mesh({.C = 0.2});
  CHECK(mesh.certificate().certified);
  CHECK(mesh.certificate().components == 1);
  CHECK(filled.certify(mesh.triangles(), {.C = 0.2}).certified);
  CHECK_FALSE(whole.certify(mesh.triangles(), {.C = 0.2}).is_homeomorphic);
  CHECK(kind_of([&] { Skin(atoms, {.drop_voids_below = -1}); }) == Error::Kind::Refused);
}

TEST_CASE("threads, progress and the life of the skin change nothing of a mesh") {
  std::set<std::string> stages;
  const morskin::RunOptions watched{
      .threads = 2, .progress = [&](std::string_view stage, double) { stages.emplace(stage); }};
  const auto mesh_of = [&](const morskin::RunOptions& run) {
    const Skin skin(three_atoms, balls, run);
    return skin.mesh({.C = 0.1}, run);
  };
  const SkinMesh plain = mesh_of({}), other = mesh_of(watched);
  CHECK(plain.triangles().vertices == other.triangles().vertices);
  CHECK(plain.triangles().triangles == other.triangles().triangles);
  for (const char* stage : {"triangulate", "mixed complex", "dual complex", "sweep", "certify"}) {
    CHECK_MESSAGE(stages.contains(stage), stage);
  }
  CHECK(plain.points().size() == plain.triangles().vertices.size());
}

TEST_CASE("each vertex has the normal, the atom and the component that it must have") {
  const Skin skin(three_atoms, balls);
  CHECK(skin.components() == 2);
  const SkinMesh mesh = skin.mesh();
  const std::vector<SkinPoint> points = mesh.points();
  std::set<std::uint32_t> atoms;
  std::map<std::uint32_t, std::set<bool>> sides;  // by component
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Point& x = mesh.triangles().vertices[v];
    const SkinPoint& p = points[v];
    const bool is_alone = x[0] > 5;
    CHECK(dot(p.normal, p.normal) == doctest::Approx(1));
    CHECK((p.atom == 2) == is_alone);
    atoms.insert(p.atom);
    sides[p.component].insert(is_alone);
    if (!is_alone) continue;
    CHECK(p.length_scale == doctest::Approx(2));
    CHECK(dot(p.normal, x - three_atoms[2].position) == doctest::Approx(2));
    CHECK(p.curvatures[0] == doctest::Approx(0.5));
    CHECK(p.curvatures[1] == doctest::Approx(0.5));
  }
  CHECK(atoms == std::set<std::uint32_t>{0, 1, 2});
  CHECK(sides.size() == 2);
  for (const auto& [component, side] : sides) CHECK(side.size() == 1);
}

TEST_CASE("the Gaussian curvature adds up to 2 pi times the Euler characteristic") {
  // Balls, a ring with a hole, a hollow shell with a void: 2, 0 and 4.
  for (const auto& [name, characteristic] :
       {std::pair{"two_balls.xyzr", 2}, {"ring12.xyzr", 0}, {"shell_hollow.xyzr", 4}}) {
    const std::string file = std::string("bench/molecules/") + name;
    CAPTURE(file);
    const auto atoms = morskin::read_molecule(file);
    const Skin skin(atoms, balls);
    CHECK(2 * static_cast<long>(skin.components()) - 2 * static_cast<long>(skin.genus()) ==
          characteristic);
    const SkinMesh mesh = skin.mesh({.C = 0.05});
    const std::vector<SkinPoint> points = mesh.points();
    double sum = 0, total = 0;  // of the curvature, and of its magnitude
    for (const auto& corners : mesh.triangles().triangles) {
      const auto& [a, b, c] = corners;
      const auto& x = mesh.triangles().vertices;
      const Point area = cross(x[b] - x[a], x[c] - x[a]);
      for (const std::uint32_t v : corners) {
        const double part =
            std::sqrt(dot(area, area)) / 6 * points[v].curvatures[0] * points[v].curvatures[1];
        sum += part;
        total += std::abs(part);
        const auto& [k1, k2] = points[v].curvatures;
        CHECK(k1 >= k2);
        CHECK(std::max(std::abs(k1), std::abs(k2)) ==
              doctest::Approx(1 / points[v].length_scale).epsilon(1e-9));
        const Point& normal = points[v].normal;
        CHECK(dot(cross(points[v].directions[0], points[v].directions[1]), normal) ==
              doctest::Approx(1));
      }
    }
    // Curvature jumps where patches meet, and a triangle there has some of both.
    CHECK(std::abs(sum - 2 * M_PI * characteristic) < 0.02 * total);
  }
}

TEST_CASE("the atoms' shares give back x - N, and the larger curvature its direction") {
  const auto atoms = morskin::read_molecule("bench/molecules/caffeine.xyz");
  const SkinMesh mesh = Skin(atoms).mesh({.C = 0.3});
  const std::vector<SkinPoint> points = mesh.points();
  for (std::size_t v = 0; v < points.size(); ++v) {
    const SkinPoint& p = points[v];
    Point mean{0, 0, 0};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK((p.atoms[i] >= 0 || p.shares[i] == 0));
      if (p.atoms[i] < 0) continue;
      sum += p.shares[i];
      for (std::size_t k = 0; k < 3; ++k) {
        mean[k] += p.shares[i] * atoms[static_cast<std::size_t>(p.atoms[i])].position[k];
      }
    }
    CHECK(sum == doctest::Approx(1));
    const Point N = mesh.triangles().vertices[v] - mean;
    CHECK(std::sqrt(dot(N, N)) == doctest::Approx(p.length_scale));
    CHECK(std::abs(dot(p.directions[0], p.normal)) < 1e-9);
    CHECK(std::abs(dot(p.directions[0], p.directions[1])) < 1e-9);
    CHECK(dot(p.directions[1], p.directions[1]) == doctest::Approx(1));
  }
}

TEST_CASE("a mesh certifies again with the sizing that it tells, whatever size was asked for") {
  const Skin skin(three_atoms, balls);
  for (const MeshOptions& options : {MeshOptions{}, MeshOptions{.C = 0.4, .density = 10},
                                     MeshOptions{.C = 0.4, .edge_length = 0.3}}) {
    const SkinMesh mesh = skin.mesh(options);
    CHECK(skin.certify(mesh.triangles(), mesh.sizing()).certified);
    CHECK(mesh.sizing().C == options.C);
  }
}

TEST_CASE("a mesh is written under its name only if it is certified") {
  const morskin::support::TemporaryFolder folder;
  const Skin skin(three_atoms, balls);
  const SkinMesh good = skin.mesh({.C = 0.3});
  CHECK(good.write(folder / "a.off") == folder / "a.off");
  CHECK(morskin::read_mesh(folder / "a.off").triangles == good.triangles().triangles);
  // [U] allows triangles as large as the balls, too large to be proved near the skin.
  const SkinMesh bad = skin.mesh({.C = 0.9, .Q = 1.9, .angle_goal_deg = 0});
  CHECK_FALSE(bad.certificate().certified);
  CHECK(bad.write(folder / "b.off") == folder / "b.off.unverified");
  CHECK_FALSE(std::filesystem::exists(folder / "b.off"));
  CHECK(morskin::read_mesh(folder / "b.off.unverified").triangles == bad.triangles().triangles);
  CHECK(kind_of([&] { bad.write(folder / "b.xyz"); }) == Error::Kind::Unwritable);
}

TEST_CASE("critical points add up to the Euler characteristic, and arcs and regions join them") {
  for (const auto& [name, characteristic] :
       {std::pair{"two_balls.xyzr", 2}, {"ring12.xyzr", 0}, {"shell_hollow.xyzr", 4}}) {
    const std::string file = std::string("bench/molecules/") + name;
    CAPTURE(file);
    const Skin skin(morskin::read_molecule(file), balls);
    for (const std::optional<Point>& direction :
         {std::optional<Point>(), std::optional<Point>({0.3, 0.9, 0.2})}) {
      std::array<int, 3> counts{};
      for (const auto& p : skin.critical_points(direction)) ++counts.at(std::size_t(p.index));
      CHECK(counts[0] - counts[1] + counts[2] == characteristic);
      const morskin::MorseSmaleComplex complex = skin.morse_smale(direction);
      const auto& points = complex.points;
      CHECK(complex.arcs.size() == 4 * std::size_t(counts[1]));
      CHECK(complex.regions.size() == 2 * std::size_t(counts[1]));
      REQUIRE(complex.arc_offsets.size() == complex.arcs.size() + 1);
      CHECK(complex.arc_offsets.back() == complex.arc_points.size());
      for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
        const auto [saddle, extremum] = complex.arcs[i];
        CHECK(points[saddle].index == 1);
        CHECK(points[extremum].index != 1);
        CHECK(complex.arc_points[complex.arc_offsets[i]] == points[saddle].position);
        CHECK(complex.arc_points[complex.arc_offsets[i + 1] - 1] == points[extremum].position);
      }
      for (const auto& [a, b, c, d] : complex.regions) {
        CHECK((points[a].index == 0 && points[c].index == 2));
        CHECK((points[b].index == 1 && points[d].index == 1));
      }
    }
    CHECK(kind_of([&] { skin.critical_points(Point{0, 0, 0}); }) == Error::Kind::Refused);
    CHECK(kind_of([&] { skin.morse_smale(Point{0, std::nan(""), 0}); }) == Error::Kind::Refused);
  }
}

TEST_CASE("a direction may be of any length, however long or short") {
  const Skin skin(three_atoms, balls);
  const auto along = [&](double length) {
    return skin.mesh({.C = 0.3, .fronts = 1, .direction = Point{length, 2 * length, 2 * length}})
        .triangles()
        .vertices;
  };
  const auto vertices = along(1);
  for (const double length : {0x1p-1060, 0x1p-600, 2., 0x1p1000}) CHECK(along(length) == vertices);
}

TEST_CASE("elements have radii, in upper or lower case, and other words have none") {
  CHECK(morskin::van_der_waals_radius("C") == 1.7);
  CHECK(morskin::van_der_waals_radius("cl") == morskin::van_der_waals_radius("CL"));
  CHECK_FALSE(morskin::van_der_waals_radius("no element"));
}

TEST_CASE("features are arrays by vertex, by atom and of the Laplacian, of a certified mesh") {
  const auto [mesh, arrays] = morskin::features("bench/molecules/benzene.pdb");
  CHECK(mesh.certificate().certified);
  std::map<std::string, std::size_t> rows;
  for (const morskin::FeatureArray& array : arrays) {
    const std::size_t size = std::visit([](const auto& all) { return all.size(); }, array.values);
    CHECK(size % array.columns == 0);
    CHECK(rows.emplace(array.name, size / array.columns).second);
  }
  const std::size_t vertices = rows.at("vertices"), faces = rows.at("faces");
  CHECK(vertices == mesh.triangles().vertices.size());
  CHECK(faces == 2 * vertices - 4);
  for (const char* name : {"normals", "k1", "shape_index", "atom", "hphob", "mass"}) {
    CHECK(rows.at(name) == vertices);
  }
  CHECK(rows.at("laplacian_data") == vertices + 3 * faces);
  CHECK(rows.at("atom_name") == 12);
  CHECK_FALSE(rows.contains("partial_charge"));
}

TEST_CASE("a run stops at whatever report it is asked to") {
  std::size_t reports = 0;
  const auto run_until = [&](std::size_t last) {
    std::stop_source source;
    reports = 0;
    const morskin::RunOptions run{.progress =
                                      [&, last](std::string_view, double) {
                                        if (++reports == last) source.request_stop();
                                      },
                                  .stop = source.get_token()};
    return kind_of([&] { Skin(three_atoms, balls, run).mesh({.C = 0.1}, run); });
  };
  CHECK_FALSE(run_until(1000000));
  const std::size_t all = reports;
  CHECK(all >= 8);
  for (std::size_t last = 1; last < all; ++last) {
    CHECK(run_until(last) == Error::Kind::Stopped);
    CHECK(reports == last);
  }
}
