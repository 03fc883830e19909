#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace morskin::geometry {

/// The bytes of a file.
class FileBytes {
 public:
  FileBytes(std::unique_ptr<char[]> bytes, std::size_t size)
      : bytes_(std::move(bytes)), size_(size) {}
  std::string_view view() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_;
};

/// Reads all of a file; "-" is standard input.
///
/// @param max_bytes  limit, since a device or a pipe may never end
/// @throws UnreadableInput  if it is missing, a directory, not permitted, longer, or fails while
///                          being read
FileBytes read_file(const std::filesystem::path& path,
                    std::size_t max_bytes = std::numeric_limits<std::size_t>::max() / 4);

/// @param error  of the system
/// @throws UnreadableInput  "path: cannot be opened: reason; what to do"
[[noreturn]] void fail_to_open(const std::filesystem::path& path, int error);

/// Writes all of it to an open file. @return 0, or the error of the write that failed
int write_all(int file, std::string_view bytes);

/// @param error  of the system
/// @throws UnwritableOutput  "path: cannot write: reason; what to do"
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

/// Whether `path` is written to directly, since no file could be renamed to it: "-" and
/// "/dev/stdout" (standard output), "/dev/stderr" (standard error), and whatever else exists and is
/// neither a regular file nor a folder (a pipe, /dev/null).
bool is_written_directly(const std::filesystem::path& path);

/// The file that `path` leads to through symbolic links, whether it exists or not; `path` itself if
/// it is no link.
/// @param error  set where they lead round in a circle or cannot be read
std::filesystem::path link_target(std::filesystem::path path, std::error_code& error);

/// A file under a temporary name beside its final one, which commit() gives it. Without commit()
/// the destructor removes it.
class PendingFile {
 public:
  /// Creates the temporary file, empty. Follows a symbolic link at `path` and copies an existing
  /// file's permissions.
  ///
  /// @pre    !is_written_directly(path)
  /// @throws UnwritableOutput  as from fail_to_write()
  explicit PendingFile(std::filesystem::path path);
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&& other) = delete;
  ~PendingFile();

  const std::filesystem::path& path() const { return path_; }
  const std::string& temporary_name() const { return temporary_; }
  /// The name it gets from commit(suffix).
  std::filesystem::path final_name(std::string_view suffix = {}) const;

  /// Replaces the contents by `bytes`. @pre before commit().
  /// @throws UnwritableOutput  as above
  void write(std::string_view bytes);

  /// Reads what the file holds into the memory that it was written from: as much again need not be
  /// had. @pre before commit().
  ///
  /// @param bytes  as they were written
  /// @throws UnreadableInput  it cannot be read, or is longer or shorter
  void read_again(std::string& bytes) const;

  /// Renames the file to its final name with `suffix` added, replacing an older file of that name.
  /// Does not force the data onto the disk.
  ///
  /// @return the new name
  /// @throws UnwritableOutput  as above
  std::filesystem::path commit(std::string_view suffix = {});

 private:
  std::filesystem::path path_;    ///< as the user named it
  std::filesystem::path target_;  ///< the target of its link, or the same
  std::string temporary_;         ///< empty once the file has its name
  int number_ = -1;               ///< descriptor, while open
};

/// Makes `path` a file of exactly these bytes, whole or not at all: through a PendingFile, or
/// directly where is_written_directly says so.
///
/// @throws UnwritableOutput  as above; an older file at `path` is unchanged
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace morskin::geometry
