#pragma once

/// Threads, progress, stop request and stage times of a run, passed to every stage of the pipeline.
/// The result depends on none of them.

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string_view>
#include <utility>

#include "geometry/stopwatch.h"
#include "geometry/task_trace.h"

namespace morskin::geometry {

/// Where a run stands: its stage, and the share of it that is done, 0 to 1 or unknown_share. Called
/// from one thread at a time, not always the same.
using Progress = std::function<void(std::string_view stage, double share)>;
inline constexpr double unknown_share = -1;

/// The run was asked to stop, and did.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped on request") {}
};

/// Copies are the same run. One thread begins and ends its stages, one after the other.
class Run {
 public:
  /// @param threads   how many may be used, at most; 0 counts as 1
  /// @param progress  may be empty
  /// @param stop      checked wherever progress is reported
  explicit Run(unsigned threads = 1, Progress progress = {}, std::stop_token stop = {});

  unsigned threads() const { return threads_; }
  /// Whether reports lead to anything, so that it pays to prepare them.
  bool is_watched() const { return state_->progress || state_->stop.stop_possible(); }

  /// Does a piece of work as (part of) a stage, and gives on what it returns.
  /// @param name  must outlive the run, as a literal does
  /// @throws Stopped
  template <class Work>
  auto stage(std::string_view name, Work work) const {
    state_->stage = name;
    report(unknown_share);
    const Traced traced(TaskTrace::Kind::Stage, name);
    return timed(state_->seconds[name], std::move(work));
  }
  /// Reports the share of the present stage that is done. From any thread, one at a time.
  /// @param detail  shown behind the stage's name
  /// @throws Stopped
  void report(double share, std::string_view detail = {}) const;

  /// What a stage has taken so far, by the wall clock.
  double seconds(std::string_view stage) const;

 private:
  struct State {
    Progress progress;
    std::stop_token stop;
    std::string_view stage;
    std::map<std::string_view, double> seconds;  ///< by stage
  };

  unsigned threads_;
  std::shared_ptr<State> state_;
};

}  // namespace morskin::geometry
