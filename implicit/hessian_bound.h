#pragma once

/// A bound on the second derivatives of a function over a ball, by branch and bound.

#include "geometry/run.h"
#include "implicit/function.h"
#include "surface/bounding_ball.h"

namespace morskin::implicit {

/// What levels f off where it is positive, far from the surface: f stays as it is where f <= 0, and
/// becomes (1 - exp(-rate f)) / rate outside. Value and gradient go over into each other.
struct Levelling {
  double rate = 0;  ///< 0 leaves f alone

  /// The derivative by f, from 1 at the surface down.
  double slope(double f) const { return f > 0 ? std::exp(-rate * f) : 1; }
  double value(double f) const { return f > 0 && rate > 0 ? -std::expm1(-rate * f) / rate : f; }
};

/// Upper bound on the spectral norm of the Hessian of the levelled f in a ball, where it has one:
/// proved, and within a fifth of the largest, as far as the number of boxes allows.
/// @param useless  so large a bound is of no use: the search ends where there can be no smaller one
/// @return  infinity where no bound is found
double hessian_bound(const Function& f, const Levelling& levelling,
                     const surface::BoundingBall& ball, double useless, const geometry::Run& run);

}  // namespace morskin::implicit
