#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

struct archive;

namespace morskin::app {

/// The files in a tar archive, plain or compressed (gzip, bzip2, xz, zstd), one after the other.
class Archive {
 public:
  /// @throws geometry::UnreadableInput  from here and from both functions
  explicit Archive(std::filesystem::path path);

  /// Goes on to the next regular file or link.
  /// @return its name, without ./ before it; nothing at the end, where checksums are right
  std::optional<std::string> next();
  /// Whether that is a link, whose content stands elsewhere or nowhere.
  bool is_link() const { return is_link_; }

  /// Writes the file that next() named. @pre it did, and this is the first call since
  /// @param longest  bytes; a longer file is not unpacked. One more zero than these stands in its
  ///                 place, without taking space, so that readers with this limit refuse it
  /// @throws geometry::UnwritableOutput  also
  void extract(const std::filesystem::path& target, std::size_t longest);

 private:
  [[noreturn]] void fail() const;

  struct Source;
  struct Close {
    void operator()(archive* opened) const;
    void operator()(Source* opened) const;
  };
  std::filesystem::path path_;
  std::unique_ptr<Source, Close> source_;
  std::unique_ptr<archive, Close> archive_;
  bool is_link_ = false;
  std::uintmax_t size_ = 0;  ///< of the file, bytes
};

/// Whether a name is one of a tar archive: .tar, also with .gz, .bz2, .xz or .zst, and .tgz.
bool names_an_archive(const std::filesystem::path& path);

}  // namespace morskin::app
