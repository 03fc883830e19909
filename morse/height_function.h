#pragma once

#include "geometry/point.h"

namespace morskin::morse {

using geometry::Point;
using geometry::Vector;

/// The Morse function of the paper (section 3.1): height h(x) = direction . x.
///
/// The paper's direction is y. Symmetric molecules are degenerate along an axis of symmetry
/// (critical points in pairs, or on cell walls), so the default is y with a small fixed tilt.
struct HeightFunction {
  Vector direction = Vector(0.0231, 1.0, 0.0137).normalized();  ///< unit

  double operator()(const Point& x) const { return direction.dot(x); }
};

}  // namespace morskin::morse
