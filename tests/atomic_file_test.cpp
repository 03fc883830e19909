#include "geometry/files/atomic_file.h"

#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "geometry/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

/// While it lives no file of the process grows beyond so many bytes: the write that would reaches
/// the limit, and the next one fails.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &usual_);
    const rlimit limit{bytes, usual_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &usual_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit usual_{};
};

}  // namespace

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

TEST_CASE("a name with a NUL is refused, and the file of the name up to there is left alone") {
  const TemporaryFolder folder;
  const auto before = folder.file("a", "old");
  const std::filesystem::path name = before.native() + std::string(1, '\0') + "b.ply";
  CHECK_THROWS_WITH_AS(read_file(name), doctest::Contains("a?b.ply: no file has a NUL"),
                       UnreadableInput);
  CHECK_THROWS_WITH_AS(write_file_atomically(name, "new"),
                       doctest::Contains("a?b.ply: no file has a NUL"), UnwritableOutput);
  CHECK(bytes_of(before) == "old");
  CHECK(folder.file_count() == 1);
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

TEST_CASE("what does not fit whole gets no name, and leaves the older file and no other") {
  constexpr std::size_t limit = 1000;
  for (const bool has_older : {false, true}) {
    for (const std::size_t size : {limit - 1, limit, limit + 1, 2 * limit, 1000 * limit}) {
      CAPTURE(has_older);
      CAPTURE(size);
      const TemporaryFolder folder;
      const std::filesystem::path path = folder / "mesh.ply";
      if (has_older) folder.file("mesh.ply", "old");
      std::string said;
      {
        const FileSizeLimit limited(limit);
        try {
          write_file_atomically(path, std::string(size, 'x'));
        } catch (const UnwritableOutput& error) {
          said = error.what();
        }
      }
      if (size <= limit) {
        CHECK(said.empty());
        CHECK(bytes_of(path) == std::string(size, 'x'));
      } else {
        CHECK(said == path.string() + ": cannot write: File too large; choose another folder or " +
                          "allow larger files (ulimit -f)");
        CHECK(bytes_of(path) == (has_older ? "old" : ""));
      }
      CHECK(folder.file_count() == (size <= limit || has_older ? 1 : 0));
    }
  }
}

TEST_CASE("where no more files may be open the name of one is not to blame") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.file("balls.xyzr", "0 0 0 1");
  rlimit usual{};
  ::getrlimit(RLIMIT_NOFILE, &usual);
  const rlimit none{0, usual.rlim_max};
  ::setrlimit(RLIMIT_NOFILE, &none);
  std::string said;
  try {
    static_cast<void>(read_file(path));
  } catch (const UnreadableInput& error) {
    said = error.what();
  }
  ::setrlimit(RLIMIT_NOFILE, &usual);
  CHECK(said == path.string() + ": cannot be opened: Too many open files; allow more open files " +
                    "(ulimit -n)");
}

TEST_CASE("a file that was written before is replaced whole by a shorter one") {
  const TemporaryFolder folder;
  PendingFile file(folder / "mesh.ply");
  for (const std::size_t size : {5000UL, 10UL, 0UL, 100UL}) {
    file.write(std::string(size, 'x'));
    CHECK(bytes_of(file.temporary_name()).size() == size);
  }
  CHECK(file.commit(".unverified") == folder / "mesh.ply.unverified");
  CHECK(bytes_of(folder / "mesh.ply.unverified").size() == 100);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a file that cannot have its name is told of, and gone") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  {
    PendingFile file(folder / "mesh.ply");
    file.write("new");
    fs::create_directory(folder / "mesh.ply");  // after it was found to be free
    CHECK_THROWS_WITH_AS(file.commit(), doctest::Contains("name a file, not a folder"),
                         UnwritableOutput);
    CHECK(file.commit(".unverified") == folder / "mesh.ply.unverified");  // another name will do
  }
  CHECK(folder.file_count() == 2);
  {
    PendingFile file(folder / "mesh.ply.unverified");
    file.write("newer");
    fs::create_directory(folder / "mesh.ply.unverified.too");
    CHECK_THROWS_AS(file.commit(".too"), UnwritableOutput);
  }
  CHECK(folder.file_count() == 3);
  CHECK(bytes_of(folder / "mesh.ply.unverified") == "new");
}

TEST_CASE("where the folder goes away meanwhile neither the bytes nor the name are lost silently") {
  const TemporaryFolder folder;
  for (const bool is_open : {false, true}) {
    CAPTURE(is_open);
    std::filesystem::create_directory(folder / "inner");
    PendingFile file(folder / "inner/mesh.ply");
    if (!is_open) file.write("new");
    std::filesystem::remove_all(folder / "inner");
    if (!is_open) {
      CHECK_THROWS_WITH_AS(file.write("newer"), doctest::Contains("create the folder first"),
                           UnwritableOutput);
    }
    CHECK_THROWS_WITH_AS(file.commit(), doctest::Contains("create the folder first"),
                         UnwritableOutput);
  }
}

TEST_CASE("a file that fails while it is read is told of") {
  if (!std::filesystem::exists("/proc/self/mem")) return;
  // Nothing is mapped at its beginning.
  CHECK_THROWS_WITH_AS(read_file("/proc/self/mem"), doctest::Contains("reading failed"),
                       UnreadableInput);
}

TEST_CASE("what is read again is what the file holds now, unless it has another length") {
  const TemporaryFolder folder;
  PendingFile file(folder / "mesh.ply");
  std::string bytes = "abc";
  file.write(bytes);
  const auto change_to = [&](std::string_view content) {
    std::ofstream(file.temporary_name(), std::ios::binary) << content;
  };
  change_to("abd");
  file.read_again(bytes);
  CHECK(bytes == "abd");
  for (const char* other : {"", "ab", "abcd"}) {
    CAPTURE(other);
    change_to(other);
    bytes = "abc";
    CHECK_THROWS_WITH_AS(file.read_again(bytes), doctest::Contains("lost or gained bytes"),
                         UnreadableInput);
  }
  std::filesystem::remove(file.temporary_name());
  CHECK_THROWS_WITH_AS(file.read_again(bytes), doctest::Contains("cannot be read again"),
                       UnreadableInput);
}
