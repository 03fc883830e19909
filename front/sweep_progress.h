#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>

#include "front/sweep_observer.h"
#include "geometry/run.h"

namespace morskin::front {

/// The share of the expected triangles that sweeps have laid. Each may report from its own thread.
class LaidTriangles {
 public:
  /// @param run  receives the share, by one thread at a time
  LaidTriangles(double expected, const geometry::Run& run) : expected_(expected), run_(run) {}

  void add(std::size_t count) {
    const std::lock_guard lock(mutex_);
    laid_ += static_cast<double>(count);
    run_.report(std::min(laid_ / expected_, 1.0));
  }

 private:
  const double expected_;
  const geometry::Run run_;
  std::mutex mutex_;
  double laid_ = 0;
};

/// Reports every few thousand triangles.
class ProgressObserver : public SweepObserver {
 public:
  explicit ProgressObserver(LaidTriangles& laid) : laid_(laid) {}

  void follow(const FrontChange&) override {
    constexpr std::size_t between_reports = 4096;
    if (++count_ % between_reports == 0) laid_.add(between_reports);
  }

 private:
  LaidTriangles& laid_;
  std::size_t count_ = 0;
};

}  // namespace morskin::front
