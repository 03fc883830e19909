#pragma once

#include <array>

#include "geometry/point.h"

namespace morskin::refine {

using geometry::Point;

/// The centre of the sphere through four points, off by less than 1e-5 of the longest edge where
/// the radius is no longer than that edge; farther out the error grows with the square of the
/// radius.
///
/// @pre the points do not lie in one plane.
Point circumcentre(const std::array<const Point*, 4>& p);

}  // namespace morskin::refine
