#pragma once

#include <chrono>

namespace morskin::front {

/// Runs a piece of work and adds its time, by the wall clock, to a stage's seconds.
template <class Work>
void timed(double& seconds, Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace morskin::front
