#pragma once

#include <algorithm>
#include <vector>

#include "geometry/box.h"

namespace morskin::front {

using geometry::Box;
using geometry::Point;

/// The subdomain of a sweep, given in space as there are no vertices yet: a box, less balls about
/// minima that a later sweep lays bowls at. Sweeps over disjoint boxes do not meet, and so may run
/// at once.
struct SweepRegion {
  struct Ball {
    Point centre;
    double radius;
  };
  Box box = {};
  std::vector<Ball> kept_bare = {};

  /// Whether all that lies within a distance of x does.
  bool contains(const Point& x, double distance) const {
    return box.contains(x, distance) && std::ranges::none_of(kept_bare, [&](const Ball& ball) {
             return (x - ball.centre).norm() < ball.radius + distance;
           });
  }
};

}  // namespace morskin::front
