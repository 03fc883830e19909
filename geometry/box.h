#pragma once

#include <limits>

#include "geometry/point.h"

namespace morskin::geometry {

/// A box with its sides along the axes; all of space unless told otherwise.
struct Box {
  Point low = Point::Constant(-std::numeric_limits<double>::infinity());
  Point high = Point::Constant(std::numeric_limits<double>::infinity());

  /// Whether all that lies within a distance of x does.
  bool contains(const Point& x, double distance) const {
    return (x.array() - distance >= low.array()).all() &&
           (x.array() + distance <= high.array()).all();
  }
  /// Whether a point of it lies within a distance of x.
  bool meets(const Point& x, double distance) const {
    return (x - x.cwiseMax(low).cwiseMin(high)).squaredNorm() <= distance * distance;
  }
};

}  // namespace morskin::geometry
