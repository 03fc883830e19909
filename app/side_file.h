#pragma once

/// A text beside a mesh: its report, its certificate, the areas of atoms.

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "geometry/files/atomic_file.h"

namespace morskin::app {

/// A regular file gets its name together with the mesh's. Standard output, a device or a pipe gets
/// the text at the very end.
class SideFile {
 public:
  /// What a mesh that is not certified makes of it: nothing, or the file's name says so and nothing
  /// else gets the text.
  enum class IfUnverified { Same, Marked };

  /// Takes its file from the end of those that are staged, if it has one there.
  /// @throws geometry::UnwritableOutput  a folder has the name of the marked file
  SideFile(const std::optional<std::filesystem::path>& name, IfUnverified doubt,
           std::span<geometry::PendingFile>& staged);

  bool is_asked() const { return name_.has_value(); }
  /// @throws geometry::UnwritableOutput
  void write(std::string text);
  /// Gives the file its name.
  void commit(bool is_certified);
  /// Gives the text to what is no file.
  void write_directly(bool is_certified) const;

 private:
  std::optional<std::filesystem::path> name_;
  IfUnverified doubt_;
  geometry::PendingFile* file_ = nullptr;
  std::string text_;  ///< where there is no file
};

}  // namespace morskin::app
