#pragma once

#include "geometry/point.h"

namespace morskin::morse {

using geometry::Point;
using geometry::Vector;

/// A Morse function of space, restricted to the skin (section 3.1): the height along a direction,
/// as in the paper, or the squared distance from a point, one of its "other Morse functions"
/// (section 6). Both are one formula,
///
///     f(x) = direction . x + curvature |x - origin|^2.
///
/// The paper's height is y. Symmetric molecules are degenerate along an axis of symmetry (critical
/// points in pairs, or on cell walls), so the default is y with a small fixed tilt.
struct MorseFunction {
  Vector direction = Vector(0.0231, 1.0, 0.0137).normalized();  ///< unit for a height, or zero
  Point origin = Point::Zero();                                 ///< of the squared distance
  double curvature = 0;  ///< 0 for a height, 1 for a squared distance, -1 for one reversed

  /// @pre direction is not zero.
  static MorseFunction height(const Vector& direction) { return {direction.normalized()}; }
  /// The same of any direction, also one whose length would overflow or vanish when squared.
  static MorseFunction height_along(const Vector& direction) {
    const double length = direction.stableNorm();
    return height(length > 0 ? Vector(direction / length) : direction);
  }
  static MorseFunction squared_distance(const Point& from) { return {Vector::Zero(), from, 1}; }

  bool is_height() const { return curvature == 0; }

  // [excerpt: function]
  /// -f: exchanges minima and maxima, keeps saddles.
  MorseFunction reversed() const { return {-direction, origin, -curvature}; }

  /// Angstrom for a height, Angstrom^2 for a squared distance.
  double operator()(const Point& x) const {
    return direction.dot(x) + curvature * (x - origin).squaredNorm();
  }
  /// The gradient in space; that on the skin lacks the part along the normal.
  Vector gradient(const Point& x) const { return direction + 2 * curvature * (x - origin); }
  // [/excerpt]
};

}  // namespace morskin::morse
