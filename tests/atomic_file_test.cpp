#include "geometry/files/atomic_file.h"

#include "geometry/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

TEST_CASE("a file that is replaced keeps its permissions, a link keeps its target") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const fs::path path = folder.file("report.json", "old");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("report.json", folder / "link.json");
  write_file_atomically(folder / "link.json", "new");
  CHECK(bytes_of(path) == "new");
  CHECK(fs::is_symlink(folder / "link.json"));
  CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(folder.file_count() == 2);
}

TEST_CASE("links to a file that does not exist yet lead to where it is made") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  fs::create_directory(folder / "inner");
  fs::create_symlink("inner/second.json", folder / "first.json");
  fs::create_symlink("report.json", folder / "inner/second.json");
  write_file_atomically(folder / "first.json", "new");
  CHECK(bytes_of(folder / "inner/report.json") == "new");
  CHECK(fs::is_symlink(folder / "first.json"));
  CHECK(fs::is_symlink(folder / "inner/second.json"));
  fs::create_symlink("circle.json", folder / "circle.json");
  CHECK_THROWS_AS(write_file_atomically(folder / "circle.json", "new"), UnwritableOutput);
}

TEST_CASE("a name too long is not blamed on the folder") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(write_file_atomically(folder / std::string(300, 'a'), "text"),
                       doctest::Contains("choose a shorter one"), UnwritableOutput);
}

TEST_CASE("devices are written to and not replaced") {
  namespace fs = std::filesystem;
  write_file_atomically("/dev/null", "text");
  CHECK(fs::is_character_file("/dev/null"));
  if (fs::exists("/dev/full")) {
    CHECK_THROWS_WITH_AS(write_file_atomically("/dev/full", "text"),
                         doctest::Contains("free some space"), UnwritableOutput);
    CHECK(fs::is_character_file("/dev/full"));
  }
}
