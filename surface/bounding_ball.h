#pragma once

#include <cmath>
#include <optional>

#include "geometry/point.h"

namespace morskin::surface {

struct BoundingBall {
  geometry::Point centre;
  double radius = 0;  ///< Angstrom

  /// The points `p + s direction` with low <= s <= high, Angstrom.
  struct Chord {
    double low, high;
  };
  /// The chord of a line in the ball; nothing where the line misses it.
  /// @pre direction is a unit vector
  std::optional<Chord> chord(const geometry::Point& p, const geometry::Vector& direction) const {
    const geometry::Vector off_centre = p - centre;
    const double along = off_centre.dot(direction);
    const double squared = along * along - off_centre.squaredNorm() + radius * radius;
    if (!(squared > 0)) return std::nullopt;
    return Chord{-along - std::sqrt(squared), -along + std::sqrt(squared)};
  }
};

}  // namespace morskin::surface
