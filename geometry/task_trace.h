#pragma once

/// What ran when: the stages of a run, the loops of parallel.h, their tasks. For a replay on more
/// processors than there are (bench/replay.py), and to see where threads wait.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/stopwatch.h"

namespace morskin::geometry {

/// Its own as long as it lives, the least that was free when it was first asked for.
std::uint32_t number_of_this_thread();

/// Records all that is traced in this process while it lives. One at a time.
class TaskTrace {
 public:
  enum class Kind : std::uint8_t {
    Stage,  ///< of a run
    Loop,   ///< until its last task is done
    Task,   ///< of a loop; with its number in the loop
    Box,    ///< of a dissection; with its number: it waits for its halves
  };
  /// A stretch of one thread's time.
  struct Span {
    Kind kind;
    std::string_view name;  ///< of a stage; empty else
    std::size_t number;
    std::uint32_t thread;  ///< by number_of_this_thread()
    double begin, end;     ///< seconds
  };

  TaskTrace() {
    number_of_this_thread();  // the least for the one that waits for all others
    active.store(this);
  }
  ~TaskTrace() { active.store(nullptr); }
  TaskTrace(const TaskTrace&) = delete;
  TaskTrace& operator=(const TaskTrace&) = delete;

  /// Those that have ended, in Chrome's trace format: what the viewers of browsers read.
  std::string json() const;

 private:
  friend class Traced;
  static inline std::atomic<TaskTrace*> active = nullptr;

  const Stopwatch since_;
  mutable std::mutex mutex_;
  std::vector<Span> spans_;
};

/// A span from here to the end of the scope. Costs nothing where none is recorded.
class Traced {
 public:
  /// @param name  must outlive the trace, as a literal does
  explicit Traced(TaskTrace::Kind kind, std::string_view name = {}, std::size_t number = 0)
      : trace_(TaskTrace::active.load(std::memory_order_relaxed)) {
    if (trace_ == nullptr) return;
    span_ = {kind, name, number, number_of_this_thread(), trace_->since_.seconds(), 0};
  }
  ~Traced() {
    if (trace_ == nullptr) return;
    span_.end = trace_->since_.seconds();
    const std::lock_guard lock(trace_->mutex_);
    trace_->spans_.push_back(span_);
  }
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;

 private:
  TaskTrace* const trace_;
  TaskTrace::Span span_{};
};

}  // namespace morskin::geometry
