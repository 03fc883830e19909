#pragma once

/// The priority queue of Algorithm 1. It holds corners of the front, with the generations of their
/// edges: an entry whose corner has closed meanwhile is stale and is skipped, not searched for.

#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "front/front.h"
#include "morse/morse_function.h"

namespace morskin::front {

/// A corner of the front where triangles may be laid: the paper's t.
struct Departure {
  double value;  ///< of the Morse function
  FrontEdgeId corner;
  std::uint32_t generation;

  bool operator>(const Departure& other) const {
    return value != other.value ? value > other.value : corner > other.corner;
  }
};

class Departures : public FrontMirror {
 public:
  Departures(const Front& front, const morse::MorseFunction& function)
      : front_(front), function_(function) {}

  bool empty() const { return queue_.empty(); }
  /// The lowest, current or stale. @pre !empty()
  Departure extract_min() {
    const Departure lowest = queue_.top();
    queue_.pop();
    return lowest;
  }
  bool is_current(const Departure& d) const {
    return front_[d.corner].is_open && front_[d.corner].generation == d.generation;
  }
  /// Puts back those that are current.
  void put_back(std::span<const Departure> departures) {
    for (const Departure& d : departures) {
      if (is_current(d)) queue_.push(d);
    }
  }

  /// Keeps a departure for later: one that the guard refused, or one too near the border of
  /// the sweep's region.
  void defer(const Departure& d) { refused_.push_back(d); }
  void postpone(const Departure& d) { outside_.push_back(d); }
  /// Puts them back: what was refused while the front stood differently may go now; what was
  /// outside may go in a larger region.
  void retry_refused() { put_back(std::exchange(refused_, {})); }
  void release_postponed() { put_back(std::exchange(outside_, {})); }

  void follow(const FrontChange& change) override {
    for (const FrontEdgeId e : change.opened) queue_.push(at(e));
  }
  /// Takes over all that is still current of another front, whose edges move up by `offset`: as
  /// postponed, since the border between the two fronts is gone once they go on.
  void absorb(const Departures& other, std::uint32_t offset) {
    auto queue = other.queue_;
    for (; !queue.empty(); queue.pop()) postpone_other(other, queue.top(), offset);
    for (const Departure& d : other.outside_) postpone_other(other, d, offset);
    for (const Departure& d : other.refused_) postpone_other(other, d, offset);
  }

 private:
  Departure at(FrontEdgeId e) const {
    return {function_(front_[e].position), e, front_[e].generation};
  }
  void postpone_other(const Departures& other, const Departure& d, std::uint32_t offset) {
    if (other.is_current(d)) postpone(at(FrontEdgeId{d.corner.value + offset}));
  }

  const Front& front_;
  const morse::MorseFunction& function_;
  std::priority_queue<Departure, std::vector<Departure>, std::greater<>> queue_;
  std::vector<Departure> refused_, outside_;
};

}  // namespace morskin::front
