#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "geometry/point.h"

namespace morskin::refine {

/// A ball that contains the body, with room to spare: beyond it all is outside.
struct BodyBall {
  geometry::Point middle;
  double reach = 0;  ///< its radius, Angstrom

  /// @pre there is a point with a positive weight
  explicit BodyBall(std::span<const geometry::WeightedPoint> points) {
    geometry::Point low = geometry::Point::Constant(std::numeric_limits<double>::infinity());
    geometry::Point high = -low;
    double most_weight = 0;
    for (const geometry::WeightedPoint& p : points) {
      low = low.cwiseMin(p.position);
      high = high.cwiseMax(p.position);
      most_weight = std::max(most_weight, p.weight);
    }
    middle = (low + high) / 2;
    reach = 1.01 * ((high - low).norm() / 2 + std::sqrt(most_weight));
  }

  struct Chord {
    double low, high;
  };
  /// Between which s the points `p + s direction` lie in it, if any do.
  ///
  /// @pre direction is a unit vector
  std::optional<Chord> chord(const geometry::Point& p, const geometry::Vector& direction) const {
    const geometry::Vector off_middle = p - middle;
    const double along = off_middle.dot(direction);
    const double squared = along * along - off_middle.squaredNorm() + reach * reach;
    if (!(squared > 0)) return std::nullopt;
    return Chord{-along - std::sqrt(squared), -along + std::sqrt(squared)};
  }
};

}  // namespace morskin::refine
