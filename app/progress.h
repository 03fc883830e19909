#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "app/arguments.h"
#include "geometry/run.h"

namespace morskin::app {

/// One line on standard error, "sweep 43 %", written over itself for a new stage and its first
/// share, else at most ten times a second, and wiped at the end.
class ProgressLine {
 public:
  explicit ProgressLine(ShowProgress when);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { wipe(); }

  /// @param share  of the stage that is done, 0 to 1; below 0 if unknown
  void show(std::string_view stage, double share);
  void wipe();
  /// Shows what a run reports. This must outlive the run.
  geometry::Progress callback() {
    return [this](std::string_view stage, double share) { show(stage, share); };
  }

 private:
  bool is_shown_;
  bool has_text_ = false;
  bool has_share_ = false;  ///< of the stage
  int width_ = 0;           ///< of the longest text so far
  std::string stage_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace morskin::app
