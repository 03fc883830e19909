#pragma once

#include <cstdint>
#include <limits>
#include <queue>

#include "geometry/surface_mesh.h"

namespace morskin::baselines {

/// When which triangle is to be inspected. Of entries at one time the one put in last comes first.
class InspectionQueue {
 public:
  struct Entry {
    double time;
    geometry::TriangleId triangle;
  };

  /// @pre time is a number
  void push(double time, geometry::TriangleId triangle) {
    entries_.push({{time, triangle}, turns_++});
  }

  /// The time of the next inspection, or infinity.
  double next_time() const {
    return entries_.empty() ? std::numeric_limits<double>::infinity() : entries_.top().time;
  }

  /// Takes out an entry of the next time. @pre next_time() is finite.
  Entry pop() {
    const Entry next = entries_.top();
    entries_.pop();
    return next;
  }

  std::size_t size() const { return entries_.size(); }
  void clear() { entries_ = {}; }

 private:
  struct Queued : Entry {
    std::uint64_t turn;                          ///< in which it was put in
    bool operator<(const Queued& other) const {  // what is largest is on top
      return time > other.time || (time == other.time && turn < other.turn);
    }
  };

  std::priority_queue<Queued> entries_;
  std::uint64_t turns_ = 0;
};

}  // namespace morskin::baselines
