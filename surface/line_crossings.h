#pragma once

#include <vector>

#include "surface/surface_point.h"

namespace morskin::surface {

/// A zero of G along a segment.
struct LineCrossing {
  double at;  ///< parameter on the segment, 0 to 1
  Point position;
  CellId cell;
};

struct LineCrossings {
  std::vector<LineCrossing> all;  ///< in the order of the segment
  /// False where rounding lost the path through the cells; then some may be missing.
  bool is_complete = true;
};

/// Whether a bound proves that a segment with both ends on one side of the surface stays there.
///
/// G - |x|^2 is concave and G + |x|^2 is convex (G is 2-Lipschitz in its gradient), so with s = l t
/// along a segment of length l whose ends have G = g and G = h, both positive,
///     G >= (1 - t) g + t h - t (1 - t) l^2,
/// a parabola without zero on [0, 1] exactly if l < sqrt(g) + sqrt(h). The same below zero.
/// @param length          of the segment, Angstrom
/// @param root_p, root_q  sqrt |G| at the ends, Angstrom
inline bool is_certainly_clear(double length, double root_p, double root_q) {
  return length < root_p + root_q;
}

/// Whether a bound proves that a segment from a crossing to a point on the side that it leads to
/// meets the surface no more.
///
/// Where G rises along the segment with slope s, it is at least s x - x^2 at a distance x, since
/// G + |x|^2 is convex: above zero as far as s, and sqrt G is s / 2 or more at s / 2, from where
/// is_certainly_clear() tells the rest. So the slope counts as a root. The same where G falls.
/// @param length  of the segment, Angstrom
/// @param slope   of |G| at the crossing along the segment, Angstrom, or a lower bound
/// @param root    sqrt |G| at the other end, Angstrom
inline bool is_certainly_clear_beyond(double length, double slope, double root) {
  return length < slope + root;
}

}  // namespace morskin::surface
