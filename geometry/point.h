#pragma once

#include <Eigen/Core>

namespace morskin::geometry {

/// A position in space, Angstrom.
using Point = Eigen::Vector3d;
/// A difference of positions or a direction.
using Vector = Eigen::Vector3d;

/// A ball of squared radius `weight` (Angstrom^2, may be negative) about `position`.
/// Its power distance is f(x) = |x - position|^2 - weight.
struct WeightedPoint {
  Point position;
  double weight = 0;
};

}  // namespace morskin::geometry
