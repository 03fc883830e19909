#pragma once

#include <span>

#include "geometry/predicates.h"

/// Signs about the smallest sphere orthogonal to a simplex's weighted points: its centre z, the
/// orthocentre, is the point of the simplex's span with equal power to all of them. Exact in the
/// range of predicates.h; Zero is an answer here, not a tie to break.
namespace morskin::geometry {

/// The sign of w_sigma = w_i - |z - z_i|^2, the weight of the simplex's orthocentre.
///
/// @param simplex  1 to 4 weighted points.
/// Law:    the order of the points does not matter.
/// @pre    affinely independent.
/// Source: mathematics of the mixed complex, Cheng & Shi 2004, section 2.1.
Sign orthosphere_weight_sign(std::span<const WeightedPoint> simplex);

/// The sign of f_v(z) - f_i(z), f(x) = |x - p|^2 - w. Negative: v is inside the simplex's smallest
/// orthosphere, so the simplex does not meet its dual ("attached" to v).
///
/// @param simplex  1 to 3 weighted points.
/// @pre    affinely independent.
Sign orthosphere_power_sign(std::span<const WeightedPoint> simplex, const WeightedPoint& v);

}  // namespace morskin::geometry
