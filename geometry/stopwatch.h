#pragma once

#include <chrono>

namespace morskin::geometry {

/// Runs work() and adds its wall-clock time to `seconds`. @return what work() returns
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
