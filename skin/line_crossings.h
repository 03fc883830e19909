#pragma once

/// Where a segment crosses the skin: every crossing, found piece by piece. Inside one mixed cell G
/// is a quadratic along a line, so its zeros are known in closed form and none is missed.

#include <vector>

#include "skin/skin_surface.h"

namespace morskin::skin {

/// A zero of G along a segment.
struct LineCrossing {
  double at;  ///< share of the segment, 0 to 1
  Point position;
  CellId cell;
};

struct LineCrossings {
  std::vector<LineCrossing> all;  ///< in the order of the segment
  /// False where the way through the cells was lost to rounding; then some may be missing.
  bool is_complete = true;
};

/// @param start  a cell near p; the nearer, the shorter the walk.
/// @pre    both ends are finite.
LineCrossings line_crossings(const SkinSurface& skin, const Point& p, const Point& q, CellId start);

/// Whether a segment of this length with both ends on one side of the skin surely stays there.
///
/// G - |x|^2 is concave and G + |x|^2 is convex (G is 2-Lipschitz in its gradient), so with s = l t
/// along a segment of length l whose ends have G = g and G = h, both positive,
///     G >= (1 - t) g + t h - t (1 - t) l^2,
/// a parabola without zero on [0, 1] exactly if l < sqrt(g) + sqrt(h). The same below zero.
/// @param root_p, root_q  sqrt |G| at the ends
inline bool is_surely_clear(double length, double root_p, double root_q) {
  return length < root_p + root_q;
}

}  // namespace morskin::skin
