#pragma once

#include <functional>
#include <vector>

#include "front/sweep_observer.h"
#include "morse/guide.h"

namespace morskin::front {

/// The state of a sweep.
struct Snapshot {
  const morse::MorseFunction& function;
  const Mesh& mesh;
  const Front& front;
};

/// Shows a sweep of one front at some values of the Morse function. A value that the front never
/// comes to shows the mesh in the end.
class Snapshots : public SweepObserver {
 public:
  using Callback = std::function<void(const Snapshot&)>;

  /// @param guide   must outlive the observer
  /// @param values  where to show it, in any order
  /// @param count   further values, at even steps from the lowest critical one to the highest
  Snapshots(const morse::Guide& guide, std::vector<double> values, std::size_t count,
            Callback callback);

  void departed(const Departure& t, const Front& front) override { show_up_to(t.value, front); }
  void finished(Front& front) override;

 private:
  void show_up_to(double value, const Front& front);

  const morse::Guide& guide_;
  std::vector<double> values_;  ///< ascending
  Callback callback_;
  std::size_t shown_ = 0;
};

}  // namespace morskin::front
