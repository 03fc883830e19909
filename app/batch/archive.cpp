#include "app/batch/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "app/output_names.h"
#include "geometry/error.h"
#include "geometry/files/atomic_file.h"

namespace morskin::app {

/// A file's bytes, unpacked if it is gzipped: zlib compares the checksum, libarchive does not.
struct Archive::Source {
  gzFile file;
  std::array<char, 1 << 16> block;

  /// @return how many bytes of a block; below 0 if they are damaged or cut short
  la_ssize_t read() {
    const int count = ::gzread(file, block.data(), static_cast<unsigned>(block.size()));
    int outcome = Z_OK;
    ::gzerror(file, &outcome);
    return outcome == Z_OK || outcome == Z_STREAM_END ? count : -1;
  }
  static la_ssize_t read_for(archive* reader, void* data, const void** block) {
    auto& source = *static_cast<Source*>(data);
    *block = source.block.data();
    const la_ssize_t count = source.read();
    if (count < 0) ::archive_set_error(reader, EILSEQ, "is damaged and cannot be unpacked");
    return count;
  }
};

void Archive::Close::operator()(archive* opened) const { ::archive_read_free(opened); }
void Archive::Close::operator()(Source* opened) const {
  ::gzclose(opened->file);
  delete opened;
}

Archive::Archive(std::filesystem::path path)
    : path_(std::move(path)), archive_(::archive_read_new()) {
  archive* const opened = archive_.get();
  ::archive_read_support_format_tar(opened);
  // As far as the file goes: several archives in one, as cat makes them, and all of the checksum.
  ::archive_read_set_format_option(opened, "tar", "read_concatenated_archives", "1");
  ::archive_read_support_filter_bzip2(opened);
  ::archive_read_support_filter_xz(opened);
  ::archive_read_support_filter_zstd(opened);
  const gzFile file = ::gzopen(path_.c_str(), "rb");
  if (file == nullptr) geometry::fail_to_open(path_, errno);
  source_.reset(new Source{file, {}});
  if (::archive_read_open(opened, source_.get(), nullptr, Source::read_for, nullptr) !=
      ARCHIVE_OK) {
    fail();
  }
}

std::optional<std::string> Archive::next() {
  archive_entry* entry = nullptr;
  while (true) {
    const int outcome = ::archive_read_next_header(archive_.get(), &entry);
    if (outcome == ARCHIVE_EOF) break;
    if (outcome != ARCHIVE_OK && outcome != ARCHIVE_WARN) fail();
    is_link_ =
        ::archive_entry_hardlink(entry) != nullptr || ::archive_entry_filetype(entry) == AE_IFLNK;
    if (!is_link_ && ::archive_entry_filetype(entry) != AE_IFREG) continue;
    size_ = static_cast<std::uintmax_t>(::archive_entry_size(entry));
    const char* name = ::archive_entry_pathname_utf8(entry);
    if (name == nullptr) name = ::archive_entry_pathname(entry);
    if (name != nullptr) return std::filesystem::path(name).lexically_normal().string();
  }
  // Blocks of zeros are the end. Cut between two files, an archive would seem to hold fewer.
  if (::archive_filter_bytes(archive_.get(), 0) == ::archive_read_header_position(archive_.get())) {
    throw geometry::UnreadableInput(path_.string() +
                                    ": has no end, as if it were cut short; fetch it again");
  }
  return std::nullopt;
}

void Archive::extract(const std::filesystem::path& target, std::size_t longest) {
  const int file = ::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) geometry::fail_to_write(target, errno);
  std::array<char, 1 << 16> block;
  la_ssize_t count = 0;
  int error = 0;
  const bool is_too_long = size_ > longest;
  if (is_too_long && ::ftruncate(file, static_cast<off_t>(longest) + 1) != 0) error = errno;
  while (error == 0 && !is_too_long &&
         (count = ::archive_read_data(archive_.get(), block.data(), block.size())) > 0) {
    error = geometry::write_all(file, {block.data(), static_cast<std::size_t>(count)});
  }
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) geometry::fail_to_write(target, error);
  if (count < 0) fail();
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
