#pragma once

#include "geometry/id.h"
#include "morse/morse_function.h"
#include "surface/surface_point.h"

namespace morskin::morse {

using CriticalId = geometry::Id<struct CriticalTag>;

struct CriticalPoint {
  surface::SurfacePoint point;
  int index = 0;     ///< number of descending directions: 0 minimum, 1 saddle, 2 maximum
  double value = 0;  ///< of the Morse function
  /// At a saddle a unit tangent of steepest descent and one of steepest ascent, orthogonal to each
  /// other; the opposite ones are as steep. Otherwise zero.
  Vector descending = Vector::Zero(), ascending = Vector::Zero();
};

}  // namespace morskin::morse
