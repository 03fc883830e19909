#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "front/sweep_observer.h"
#include "geometry/run.h"
#include "morse/guide.h"
#include "surface/surface.h"

namespace morskin::front {

/// The share of the atoms that one front, or two from opposite ends, have passed. Each front may
/// report from its own thread.
class PassedAtoms {
 public:
  /// @param run  receives the share, by one thread at a time
  PassedAtoms(const surface::Surface& surface, const morse::MorseFunction& function,
              const geometry::Run& run);

  void passed_from_below(double value);
  /// @param value  of the reversed function
  void passed_from_above(double value);

 private:
  double share_below(double value) const;
  void raise(double& share, double to);

  const geometry::Run run_;
  std::vector<double> values_;  ///< of the function at a sample of the atoms, ascending
  std::mutex mutex_;
  double from_below_ = 0, from_above_ = 0;
};

/// Calls back now and then with the value at the departure vertex.
class ProgressObserver : public SweepObserver {
 public:
  explicit ProgressObserver(std::function<void(double)> callback)
      : callback_(std::move(callback)) {}

  void departed(const Departure& t, const Front&) override {
    constexpr std::size_t steps_between_reports = 4096;
    if (++steps_ % steps_between_reports == 0) callback_(t.value);
  }

 private:
  std::function<void(double)> callback_;
  std::size_t steps_ = 0;
};

}  // namespace morskin::front
