#pragma once

#include <limits>

#include "morse/morse_function.h"

namespace morskin::front {

/// The subdomain of a sweep, given by levels as there are no vertices yet: the part of the surface
/// between two levels of its Morse function. Sweeps over disjoint ranges do not meet, and so may
/// run at once.
struct LevelRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool contains(double value) const { return low <= value && value <= high; }
  /// Whether all that lies within a distance of x does, where the function has the value f(x).
  bool contains(const morse::MorseFunction& function, const geometry::Point& x, double value,
                double distance) const {
    const double change = function.max_change(x, distance);
    return value + change <= high && value - change >= low;
  }
  /// The same part, by the reversed function.
  LevelRange reversed() const { return {-high, -low}; }
};

}  // namespace morskin::front
