#include "app/batch/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "app/output_names.h"
#include "geometry/error.h"

namespace morskin::app {

void Archive::Close::operator()(archive* opened) const { ::archive_read_free(opened); }

Archive::Archive(std::filesystem::path path)
    : path_(std::move(path)), archive_(::archive_read_new()) {
  archive* const opened = archive_.get();
  ::archive_read_support_format_tar(opened);
  ::archive_read_support_filter_gzip(opened);
  ::archive_read_support_filter_bzip2(opened);
  ::archive_read_support_filter_xz(opened);
  ::archive_read_support_filter_zstd(opened);
  constexpr std::size_t block_bytes = 1 << 16;
  if (::archive_read_open_filename(opened, path_.c_str(), block_bytes) != ARCHIVE_OK) fail();
}

std::optional<std::string> Archive::next() {
  archive_entry* entry = nullptr;
  while (true) {
    const int outcome = ::archive_read_next_header(archive_.get(), &entry);
    if (outcome == ARCHIVE_EOF) return std::nullopt;
    if (outcome != ARCHIVE_OK && outcome != ARCHIVE_WARN) fail();
    if (::archive_entry_filetype(entry) != AE_IFREG) continue;
    const char* name = ::archive_entry_pathname_utf8(entry);
    if (name == nullptr) name = ::archive_entry_pathname(entry);
    if (name != nullptr) return std::filesystem::path(name).lexically_normal().string();
  }
}

void Archive::extract(const std::filesystem::path& target) {
  const int file = ::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) {
    throw geometry::UnwritableOutput(target.string() + ": cannot write: " +
                                     std::generic_category().message(errno) + "; free some space");
  }
  const int outcome = ::archive_read_data_into_fd(archive_.get(), file);
  ::close(file);
  if (outcome != ARCHIVE_OK && outcome != ARCHIVE_WARN) fail();
}

void Archive::fail() const {
  const char* const reason = ::archive_error_string(archive_.get());
  throw geometry::UnreadableInput(path_.string() + ": " +
                                  (reason == nullptr ? "is no whole tar archive" : reason) +
                                  "; fetch it again");
}

bool names_an_archive(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 4> packed{".gz", ".bz2", ".xz", ".zst"};
  const std::string ending = lower_extension(path);
  const bool is_packed = std::ranges::find(packed, ending) != packed.end();
  return ending == ".tgz" || (is_packed ? lower_extension(path.stem()) : ending) == ".tar";
}

}  // namespace morskin::app
