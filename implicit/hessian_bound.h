#pragma once

/// A bound on the second derivatives of a function round its zero set, by branch and bound.

#include <algorithm>
#include <cmath>

#include "geometry/run.h"
#include "implicit/function.h"
#include "implicit/room.h"

namespace morskin::implicit {

/// What levels f off where it is positive, far from the surface: f stays as it is where f <= 0, and
/// becomes (1 - exp(-rate f)) / rate outside. Value and gradient go over into each other.
struct Levelling {
  double rate = 0;  ///< 0 leaves f alone

  /// The derivative by f, from 1 at the surface down.
  double slope(double f) const { return f > 0 ? std::exp(-rate * f) : 1; }
  /// Bounds on it, from bounds on f.
  Interval slope(const Interval& f) const {
    const Interval outside{std::max(0.0, f.low), std::max(0.0, f.high)};
    const Interval falling = exp(-(Interval(rate) * outside));
    return {falling.low, std::min(1.0, falling.high)};
  }
  double value(double f) const { return f > 0 && rate > 0 ? -std::expm1(-rate * f) / rate : f; }
};

/// Whether the Hessian of the levelled f, where it has one, has a spectral norm of at most M in the
/// room: a yes is proved. It is no where a point has more or where the boxes become too many.
bool is_hessian_bounded(const Function& f, const Levelling& levelling, const Room& room, double M,
                        const geometry::Run& run);

/// The norm at a point, or a bound close above it.
double hessian_norm(const Function& f, const Levelling& levelling, const Point& x);

}  // namespace morskin::implicit
