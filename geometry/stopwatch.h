#pragma once

#include <chrono>

namespace morskin::geometry {

/// Seconds since it was made, by the wall clock.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Runs work() and adds its time to `seconds`. @return what work() returns
template <class Work>
auto timed(double& seconds, Work work) {
  struct Added {
    double& seconds;
    Stopwatch stopwatch;
    ~Added() { seconds += stopwatch.seconds(); }
  } added{seconds, {}};
  return work();
}

}  // namespace morskin::geometry
