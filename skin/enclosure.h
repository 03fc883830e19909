#pragma once

/// Proved bounds on G and N at a point, found after the fact: whatever led to the atoms that are
/// tried, cells, walls and orthocentres with all their rounding, the bounds hold.
///
/// Relative to x let u_i = z_i - x, pi_i(y) = |y - z_i|^2 - w_i. By definition (section 2.1)
///
///     G(x) = min (|m|^2 + sum s_i pi_i(x)) / 2,   m = sum s_i u_i,
///
/// over all convex combinations s of the atoms. So any combination bounds G from above, by U. For
/// any point q, with |m|^2 >= 2 p . m - |p|^2 for p = x - q, the minimum over single atoms bounds
/// it from below (weak duality):
///
///     G(x) >= L = min pi_i(q) / 2 - |x - q|^2.
///
/// N(x) is -m of the best combination, and the minimum is one of a strongly convex function of m,
/// so |N(x) + m| <= sqrt(2 (U - L)). The best pair has q = x - m. (papers/certificate.md)

#include <span>

#include "geometry/id.h"
#include "geometry/point.h"
#include "skin/least_power.h"
#include "surface/enclosure.h"

namespace morskin::skin {

/// @param powers  of the same points
/// @param atoms   one to four to try first: the corners of x's mixed cell. Others give wide bounds
///                or cost time, never wrong bounds.
surface::Enclosure enclose(std::span<const geometry::WeightedPoint> points,
                           const LeastPower& powers, const geometry::Point& x,
                           std::span<const geometry::AtomId> atoms);

}  // namespace morskin::skin
