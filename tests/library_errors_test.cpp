// What the library refuses, and what it says of it.
#include "tests/support/library_errors.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "morskin/morskin.h"
#include "tests/support/temporary_folder.h"

using morskin::Atom;
using morskin::Error;
using morskin::MeshOptions;
using morskin::Point;
using morskin::Skin;
using morskin::SkinMesh;
using morskin::support::kind_of;

namespace {

constexpr morskin::SkinOptions balls{.model = morskin::Model::Vdw};

const std::vector<Atom> three_atoms{{{0, 0, 0}, 1.5}, {{2, 0.3, 0}, 1.2}, {{40, 0, 0}, 2}};

}  // namespace

TEST_CASE("the skin at a vertex that is not near it is refused") {
  const Skin skin(std::vector<Atom>{{{0, 0, 0}, 1}}, balls);
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const double x : {nan, infinite, 0., 3., 1000., 1e200}) {
    CAPTURE(x);
    CHECK(kind_of([&] { skin.points({{{x, 0, 0}}, {}}); }) == Error::Kind::Refused);
  }
  CHECK(skin.points({{{1.2, 0, 0}}, {}}).size() == 1);
}

TEST_CASE(
    "of a certificate only C, Q and the largest length scale are asked, and it can be stopped") {
  const Skin skin(three_atoms, balls);
  const morskin::TriangleMesh mesh = skin.mesh({.C = 0.3}).triangles();
  CHECK(skin.certify(mesh, {.C = 0.3, .edge_length = 0.01}).certified);
  CHECK(skin.certify(mesh, {.C = 0.3, .density = -1}).certified);
  std::stop_source source;
  source.request_stop();
  morskin::RunOptions run;
  run.stop = source.get_token();
  CHECK(kind_of([&] { skin.certify(mesh, {.C = 0.3}, run); }) == Error::Kind::Stopped);
}

TEST_CASE("a mesh that is not to be written after all leaves no file") {
  const morskin::SkinMesh mesh = Skin(three_atoms, balls).mesh({.C = 0.3});
  const std::vector<std::string> all{"all"};
  const morskin::support::TemporaryFolder folder;
  const auto written = folder / "stopped.vtu";
  std::size_t reports = 0, last = 1;
  std::stop_source source;
  const auto progress = [&](std::string_view stage, double) {
    CHECK(stage == "write");
    if (++reports == last) source.request_stop();
  };
  for (; last <= 3; ++last) {
    source = std::stop_source();
    reports = 0;
    const morskin::RunOptions run{.progress = progress, .stop = source.get_token()};
    CHECK(kind_of([&] { mesh.write(written, all, run); }) == Error::Kind::Stopped);
    CHECK(folder.file_count() == 0);
  }
  CHECK(mesh.write(written, all) == written);
}

TEST_CASE("what makes no sense is refused in words that name it") {
  const Skin skin(three_atoms, balls);
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const auto said = [&](const MeshOptions& options) -> std::string {
    try {
      skin.mesh(options);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  };
  for (const double length : {0., -1., nan, 1e-300, infinite}) {
    CAPTURE(length);
    CHECK(said({.C = 0.3, .edge_length = length}) ==
          "the length of edges is too small, or no finite number");
  }
  for (const double C : {nan, -1., 0., infinite}) {
    CAPTURE(C);
    CHECK(said({.C = C, .edge_length = 1}) == "C and Q must satisfy C >= 1e-5, 2 C < Q and Q > 1");
  }
  for (const double limit : {nan, -infinite, 1.}) {
    CAPTURE(limit);
    CHECK(said({.C = 0.3, .max_length_scale = limit, .edge_length = 1}).find("one of them") !=
          std::string::npos);
  }
  CHECK(said({.angle_goal_deg = -1}) == "the goal for angles must be from 0 to 60 degrees");
  CHECK(said({.density = infinite}) == "the density must be above 0 and finite");
  CHECK(said({.grading = infinite}) == "the grading must be at least 0.01 and finite");
}

TEST_CASE("atoms too small for the coordinates are named, each once") {
  using Atoms = std::vector<std::uint32_t>;
  const auto named = [](const std::vector<Atom>& atoms) -> Atoms {
    try {
      const Skin skin(atoms);
    } catch (const Error& error) {
      CHECK(error.kind() == Error::Kind::Refused);
      return error.atoms();
    }
    return {};
  };
  CHECK(named({{{1000, 0, 0}, 1e-12}}) == Atoms{0});
  CHECK(named({{{0, 0, 0}, 1e-12}, {{1000, 0, 0}, 1}}) == Atoms{0, 1});
}

TEST_CASE("a mesh with a vertex that is not finite is written to no file") {
  const morskin::support::TemporaryFolder folder;
  morskin::TriangleMesh mesh = Skin(three_atoms, balls).mesh({.C = 0.3}).triangles();
  mesh.vertices[5][1] = std::nan("");
  for (const char* name : {"a.ply", "a.off", "a.obj", "a.stl", "a.vtu", "a.msh", "a.npz"}) {
    CAPTURE(name);
    CHECK(kind_of([&] { morskin::write_mesh(mesh, folder / name); }) == Error::Kind::Refused);
    CHECK(!std::filesystem::exists(folder / name));
  }
}

TEST_CASE("an empty name of a file to write, or of a table of radii, is told as one") {
  const morskin::support::TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(Skin(three_atoms, balls).mesh({.C = 0.3}).write(""),
                       "the name of a file to write is empty; give one", Error);
  const auto atom = folder.file("a.xyz", "1\n\nC 0 0 0\n");
  CHECK_THROWS_WITH_AS(morskin::read_molecule(atom, {.radii = ""}),
                       "the name of a file to read is empty; give one", Error);
}

TEST_CASE("a vertex beyond single precision is written to no file that has no more") {
  const morskin::support::TemporaryFolder folder;
  const morskin::TriangleMesh mesh{{{0, 0, 0}, {-4e38, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  for (const char* name : {"a.stl", "a.glb"}) {
    CAPTURE(name);
    CHECK(kind_of([&] { morskin::write_mesh(mesh, folder / name); }) == Error::Kind::Refused);
    CHECK(!std::filesystem::exists(folder / name));
  }
  for (const char* name : {"a.ply", "a.off", "a.obj", "a.vtu", "a.msh"}) {
    CAPTURE(name);
    morskin::write_mesh(mesh, folder / name);
    CHECK(morskin::read_mesh(folder / name).vertices == mesh.vertices);
  }
}

TEST_CASE("a certified mesh is written to no file whose single precision spoils its triangles") {
  const morskin::support::TemporaryFolder folder;
  const std::vector<Atom> far_atoms{{{9e5, 0, 0}, 1.7}, {{9e5 + 1.4, 0, 0}, 1.7}};
  const SkinMesh far = Skin(far_atoms, balls).mesh();
  REQUIRE(far.certificate().certified);
  for (const char* name : {"a.stl", "a.glb"}) {
    CAPTURE(name);
    CHECK(kind_of([&] { far.write(folder / name); }) == Error::Kind::Refused);
    CHECK(!std::filesystem::exists(folder / name));
  }
  CHECK(far.write(folder / "a.ply") == folder / "a.ply");
  const SkinMesh near = Skin(three_atoms, balls).mesh();
  CHECK(near.write(folder / "a.stl") == folder / "a.stl");
}

TEST_CASE("a wrong name of data is refused beside all, before it or behind") {
  const morskin::support::TemporaryFolder folder;
  const SkinMesh mesh = Skin(three_atoms, balls).mesh({.C = 0.3});
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"all", "nope"}, std::vector<std::string>{"nope", "all"}}) {
    CHECK(kind_of([&] { mesh.write(folder / "a.ply", names); }) == Error::Kind::Refused);
  }
}

TEST_CASE("values that make no sense are refused, each with its kind") {
  using Kind = Error::Kind;
  const Skin skin(three_atoms, balls);
  const double nan = std::nan("");
  for (const MeshOptions& options :
       {MeshOptions{.fronts = 0}, MeshOptions{.C = 0}, MeshOptions{.C = nan},
        MeshOptions{.C = 0.9, .Q = 1.2}, MeshOptions{.Q = 1}, MeshOptions{.max_length_scale = 0},
        MeshOptions{.angle_goal_deg = 61}, MeshOptions{.edge_length = 1, .density = 1},
        MeshOptions{.density = 1, .triangles = 100},
        MeshOptions{.max_length_scale = 1, .edge_length = 1}, MeshOptions{.angle_goal_deg = nan},
        MeshOptions{.method = morskin::Method::Static, .fronts = 2}, MeshOptions{.fronts = 3},
        MeshOptions{.density = 1e9}, MeshOptions{.density = 1e300},
        MeshOptions{.direction = Point{0, 0, 0}}, MeshOptions{.direction = Point{0, nan, 0}}}) {
    CHECK(kind_of([&] { skin.mesh(options); }) == Kind::Refused);
  }
  const morskin::TriangleMesh mesh = skin.mesh({.C = 0.3}).triangles();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const MeshOptions& options :
       {MeshOptions{.C = -1}, MeshOptions{.C = infinite}, MeshOptions{.C = nan},
        MeshOptions{.Q = infinite}, MeshOptions{.max_length_scale = -1},
        MeshOptions{.max_length_scale = nan}}) {
    CHECK(kind_of([&] { skin.certify(mesh, options); }) == Kind::Refused);
  }
  CHECK_THROWS_WITH_AS(Skin(std::vector<Atom>{}), "there are no atoms, and so there is no surface",
                       Error);
  CHECK(kind_of([] { Skin(std::vector<Atom>{}); }) == Kind::Refused);
  for (const Atom& atom :
       {Atom{{0, 0, 0}, 0}, Atom{{0, 0, 0}, -1}, Atom{{0, 0, 0}, nan}, Atom{{0, nan, 0}, 1},
        Atom{{1e12, 0, 0}, 1}, Atom{{0, 0, 0}, 1e6}, Atom{{50, 0, 0}, 3e-22},
        Atom{{50, 0, 0}, 1e-30}, Atom{{50, 0, 0}, 1e-170}}) {
    try {
      Skin(std::vector{three_atoms[0], atom}, balls);
      FAIL("the second atom makes no sense");
    } catch (const Error& error) {
      CHECK(error.kind() == Kind::Refused);
      CHECK(error.atoms() == std::vector<std::uint32_t>{1});
    }
  }
  CHECK(kind_of([&] { Skin(three_atoms, {.probe = -1}); }) == Kind::Refused);
  const morskin::SkinOptions no_model{.model = static_cast<morskin::Model>(99)};
  CHECK(kind_of([&] { Skin(three_atoms, no_model); }) == Kind::Refused);
  const MeshOptions no_method{.method = static_cast<morskin::Method>(99)};
  CHECK(kind_of([&] { skin.mesh(no_method); }) == Kind::Refused);
  const auto no_way = static_cast<morskin::Simplify>(99);
  CHECK(kind_of([&] { skin.morse_smale({}, {}, no_way); }) == Kind::Refused);
  CHECK(kind_of([] { morskin::read_molecule("no such file.pdb"); }) == Kind::Unreadable);
  CHECK(kind_of([] { morskin::read_mesh("no such file.ply"); }) == Kind::Unreadable);
  CHECK(kind_of([] { morskin::write_mesh({}, "no such folder/a.ply"); }) == Kind::Unwritable);
  CHECK(kind_of([&] { skin.certify({{{0, 0, 0}}, {{0, 1, 2}}}); }) == Kind::Refused);
}

TEST_CASE("a mesh that was moved from is one still, and is not written without triangles") {
  SkinMesh mesh = Skin(three_atoms, balls).mesh({.C = 0.3});
  const SkinMesh moved = std::move(mesh);
  CHECK(mesh.triangles().triangles.size() == moved.triangles().triangles.size());
  CHECK(mesh.certificate().certified);
}

TEST_CASE("a skin that was moved from is one still") {
  Skin skin(three_atoms, balls);
  const Skin moved = std::move(skin);
  CHECK(skin.components() == moved.components());
  CHECK(skin.mesh({.C = 0.3}).certificate().certified);
}

TEST_CASE("noise in the place of zero is rounded and counted, and weights are no radii") {
  CHECK(Skin(three_atoms, balls).rounded_coordinates() == 0);
  CHECK(Skin(std::vector<Atom>{{{1e-25, 0, -3e-300}, 1}}, balls).rounded_coordinates() == 2);
  const morskin::support::TemporaryFolder folder;
  const auto weights = folder.file("a.xyzw", "0 0 0 1\n");
  CHECK(kind_of([&] { morskin::read_molecule(weights); }) == Error::Kind::Refused);
}

TEST_CASE("two balls that just touch are singular, and the error knows them") {
  // The skin's balls are sqrt 2 times as large as their patches, and so 2 sqrt 2 apart.
  try {
    Skin(std::vector<Atom>{{{-50, 0, 0}, 1}, {{0, 0, 0}, 1}, {{2, 2, 0}, 1}}, balls);
    FAIL("the balls touch in (1, 1, 0)");
  } catch (const Error& error) {
    CHECK(error.kind() == Error::Kind::Singular);
    CHECK(error.atoms() == std::vector<std::uint32_t>{1, 2});
  }
}

TEST_CASE("a file of the library says its model, sizes and verdict") {
  const morskin::support::TemporaryFolder folder;
  const auto says = [](const std::filesystem::path& file, const std::string& statement) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return text.find("# morskin: " + statement) != std::string::npos;
  };
  const Skin skin(three_atoms, {.model = morskin::Model::Sas, .probe = 0.5, .drop_voids_below = 3});
  const auto file = skin.mesh({.C = 0.4, .edge_length = 0.5}).write(folder / "a.off");
  for (const char* const statement : {"version ", "model sas\n", "probe 0.5\n", "voids 3\n",
                                      "C 0.4\n", "Q 2.4", "size 0.", "verdict certified\n"}) {
    CAPTURE(statement);
    CHECK(says(file, statement));
  }
  const SkinMesh bad = Skin(three_atoms, balls).mesh({.C = 0.9, .Q = 1.9, .angle_goal_deg = 0});
  const auto unverified = bad.write(folder / "b.off");
  for (const char* const statement : {"model vdw\n", "voids keep\n", "verdict not certified\n"}) {
    CHECK(says(unverified, statement));
  }
  for (const char* const other : {"probe", "size"}) CHECK_FALSE(says(unverified, other));
}
