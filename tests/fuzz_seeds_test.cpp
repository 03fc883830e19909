// The seeds of the fuzz targets are what their names say, so that the search starts where readers
// read.

#include <filesystem>
#include <functional>

#include "geometry/files/gzip.h"
#include "geometry/files/mesh_files.h"
#include "skin/molecule_files.h"
#include "tests/fuzz/endings.h"
#include "tests/fuzz/msms_pair.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test.h"

using namespace morskin;

namespace {

using Name = std::function<std::string(std::uint8_t)>;
using Read = std::function<void(std::string_view bytes, const std::string& name)>;

/// The names under which the seeds of a target were read.
std::set<std::string> read_seeds(const char* target, const Name& name_of, const Read& read) {
  std::set<std::string> names;
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path("tests/fuzz/seeds") / target)) {
    CAPTURE(file.path());
    const std::string bytes = support::bytes_of(file.path());
    const std::string name = name_of(static_cast<std::uint8_t>(bytes.at(0)));
    names.insert(name);
    std::filesystem::path plain = file.path();
    if (plain.extension() == ".gz") plain.replace_extension();
    const std::string ending = std::filesystem::path(name).extension();
    if (!ending.empty()) CHECK(ending == plain.extension());
    CHECK_NOTHROW(read(std::string_view(bytes).substr(1), name));
  }
  return names;
}

}  // namespace

TEST_CASE("each seed for molecules is read in the format of its name, and each format has one") {
  const auto read = [](std::string_view bytes, const std::string& name) {
    CHECK(!skin::parse_molecule(bytes, name).atoms.empty());
  };
  CHECK(read_seeds("molecule", fuzz::molecule_name, read) ==
        std::set<std::string>(fuzz::molecule_names.begin(), fuzz::molecule_names.end()));
}

TEST_CASE("each seed for meshes is read in the format of its name, and each format has one") {
  const auto read = [](std::string_view bytes, const std::string& name) {
    CHECK(!geometry::parse_mesh(bytes, name).positions.empty());
  };
  CHECK(read_seeds("mesh", fuzz::mesh_name, read) ==
        std::set<std::string>(fuzz::mesh_names.begin(), fuzz::mesh_names.end()));
}

TEST_CASE("each seed for gzip unpacks") {
  for (const auto& file : std::filesystem::directory_iterator("tests/fuzz/seeds/gzip")) {
    CAPTURE(file.path());
    CHECK(!geometry::unpack_gzip(support::bytes_of(file.path()), "a.gz", 1 << 20).empty());
  }
}

TEST_CASE("each seed for MSMS is two files that are read as one mesh, some without a triangle") {
  std::set<std::size_t> triangles;
  for (const auto& file : std::filesystem::directory_iterator("tests/fuzz/seeds/msms")) {
    CAPTURE(file.path());
    const std::string bytes = support::bytes_of(file.path());
    const auto [vertices, faces] = fuzz::msms_pair(bytes);
    CHECK(!faces.empty());
    const auto mesh = geometry::parse_msms(vertices, "a.vert", faces, "a.face");
    CHECK(!mesh.positions.empty());
    triangles.insert(mesh.triangles.size());
  }
  CHECK(triangles == std::set<std::size_t>{0, 1, 4});
}

TEST_CASE("make fuzz runs each target, and each has seeds") {
  const std::string makefile = support::bytes_of("Makefile");
  const std::string_view list = std::string_view(makefile).substr(makefile.find("\nFUZZERS = "));
  const std::string line(list.substr(0, list.find('\n', 1)));
  std::size_t targets = 0;
  for (const auto& file : std::filesystem::directory_iterator("tests/fuzz")) {
    const std::string name = file.path().stem().string();
    if (file.path().extension() != ".cpp" || !name.ends_with("_fuzz")) continue;
    CAPTURE(name);
    ++targets;
    CHECK((line + " ").find(" " + name + " ") != std::string::npos);
    const std::string seeds = "tests/fuzz/seeds/" + name.substr(0, name.size() - 5);
    CHECK(std::filesystem::is_directory(seeds));
  }
  CHECK(targets == 5);
}
