#pragma once

/// The files a command writes: created under temporary names at the start, so that an unwritable
/// folder is found before the long work, and renamed at the end, all or none.

#include <filesystem>
#include <string_view>
#include <vector>

#include "app/interruption.h"
#include "geometry/files/atomic_file.h"

namespace morskin::app {

class StagedOutputs {
 public:
  /// @throws geometry::UnwritableOutput  for the first name that cannot be written
  explicit StagedOutputs(const std::vector<std::filesystem::path>& names);

  /// The regular files: not those that geometry::is_written_directly.
  std::vector<geometry::PendingFile>& files() { return files_; }
  /// The rest: standard output, devices, pipes.
  const std::vector<std::filesystem::path>& direct() const { return direct_; }

  /// Renames the files, or does other quick work, with signals blocked.
  template <class Work>
  void undisturbed(Work work) {
    interruption_.undisturbed(work);
  }

 private:
  RemovedOnInterrupt interruption_;  // goes last: until then the files are watched
  std::vector<geometry::PendingFile> files_;
  std::vector<std::filesystem::path> direct_;
};

/// Finds out before the long work, as PendingFile does for the name itself.
/// @throws geometry::UnwritableOutput  a folder has the name with that ending
void check_unverified_name(const geometry::PendingFile& file);

/// Gives every one of the outputs these bytes.
/// @throws geometry::UnwritableOutput
void write_to_all(StagedOutputs& outputs, std::string_view bytes);

}  // namespace morskin::app
