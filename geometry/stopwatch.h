#pragma once

#include <chrono>

namespace morskin::geometry {

/// Runs a piece of work, adds its time, by the wall clock, to a stage's seconds, and gives on what
/// it returns.
template <class Work>
auto timed(double& seconds, Work work) {
  using Clock = std::chrono::steady_clock;
  struct Added {
    double& seconds;
    Clock::time_point start = Clock::now();
    ~Added() { seconds += std::chrono::duration<double>(Clock::now() - start).count(); }
  } added{seconds};
  return work();
}

}  // namespace morskin::geometry
