#pragma once

/// The files a command writes: created under temporary names at the start, so that an unwritable
/// place is known before the long work, and named at the end, all or none.

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

  /// The files that get a name; what geometry::is_written_directly is not among them.
  std::vector<geometry::PendingFile>& files() { return files_; }
  /// The rest: standard output, devices, pipes.
  const std::vector<std::filesystem::path>& direct() const { return direct_; }

  /// Gives the files their names, or does other quick work, without a signal in between.
  template <class Work>
  void undisturbed(Work work) {
    interruption_.undisturbed(work);
  }

 private:
  RemovedOnInterrupt interruption_;  // goes last: until then the files are watched
  std::vector<geometry::PendingFile> files_;
  std::vector<std::filesystem::path> direct_;
};

/// Gives every one of the outputs these bytes.
/// @throws geometry::UnwritableOutput
void write_to_all(StagedOutputs& outputs, std::string_view bytes);

}  // namespace morskin::app
