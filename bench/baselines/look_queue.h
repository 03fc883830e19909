#pragma once

#include <cstdint>
#include <limits>
#include <queue>

#include "geometry/surface_mesh.h"

namespace morskin::baselines {

/// When which triangle is to be looked at. Of looks at one time the one put in last comes first.
class LookQueue {
 public:
  struct Look {
    double time;
    geometry::TriangleId triangle;
  };

  /// @pre time is a number
  void push(double time, geometry::TriangleId triangle) {
    entries_.push({{time, triangle}, turns_++});
  }

  /// The time of the next look, or infinity.
  double next_time() const {
    return entries_.empty() ? std::numeric_limits<double>::infinity() : entries_.top().time;
  }

  /// Takes out a look at the next time. @pre next_time() is finite.
  Look pop() {
    const Look look = entries_.top();
    entries_.pop();
    return look;
  }

  std::size_t size() const { return entries_.size(); }
  void clear() { entries_ = {}; }

 private:
  struct Entry : Look {
    std::uint64_t turn;                         ///< in which it was put in
    bool operator<(const Entry& other) const {  // what is largest is on top
      return time > other.time || (time == other.time && turn < other.turn);
    }
  };

  std::priority_queue<Entry> entries_;
  std::uint64_t turns_ = 0;
};

}  // namespace morskin::baselines
