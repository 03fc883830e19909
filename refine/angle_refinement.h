#pragma once

/// The angle that is guaranteed: Delaunay refinement (Chew 1993; Cheng, Dey & Ramos 2007). While a
/// triangle has an angle below the bound, the centre of its surface ball goes in.
///
/// With a bound of at most 30 degrees such a ball is larger than the triangle's shortest edge e,
/// for R = |e| / (2 sin a). Where it is empty, the new vertex is farther than |e| from all others.
/// So no two vertices come to be nearer than the nearest two were, and a closed surface has room
/// for finitely many. Before each insertion all vertices are asked; where one is nearer, the
/// triangle is left. Triangles that come to break [U], or could not be certified, are broken as
/// well: their balls' radii are bounded from below by the length scale.

#include <cstddef>
#include <vector>

#include "geometry/run.h"
#include "refine/names.h"

namespace morskin::refine {

struct AngleRefinementCounts {
  std::size_t inserted = 0;
  /// First corners of triangles that it could not break: below the bound, or too big for [U].
  std::vector<Point> left;
};

/// @param bound_deg  at most 30, but for rounding
/// @pre the mesh is closed and compact, its edges are Delaunay. It comes out compacted.
AngleRefinementCounts refine_angles(const surface::Surface& surface, const Sizing& sizing,
                                    Mesh& mesh, double bound_deg,
                                    const geometry::Run& run = geometry::Run());

}  // namespace morskin::refine
