#pragma once

/// What moves alone leave: triangles that miss the goal, whose corners have too many or too few
/// neighbours. For each of them a vertex near it is taken out or one is put in, edges are flipped
/// until they are Delaunay again, and vertices around are moved (smoothing.h); or only that, for a
/// stricter goal. If fewer triangles miss the goal then, and none breaks [L] or [U], it stays so;
/// otherwise all is taken back and the next is tried, in the end up to four changes at once.
///
/// Source: Freitag & Ollivier-Gooch 1997, moves and changes of connectivity in turn, there for
/// tetrahedra.

#include <cstddef>
#include <span>

#include "geometry/run.h"
#include "refine/angle_goal.h"

namespace morskin::refine {

struct AngleImprovementCounts {
  std::size_t changed = 0;  ///< vertices taken out or put in for good
  std::size_t left = 0;     ///< triangles that miss the goal, after
};

/// @param below    the triangles that miss the goal
/// @param repairs  of the triangles that a change makes too big for [U] or the certificate, so many
///                 are broken as well
/// @pre the mesh is closed, its edges are Delaunay. It comes out compacted.
AngleImprovementCounts improve_angles(const surface::Surface& surface, const Sizing& sizing,
                                      Mesh& mesh, const AngleGoal& goal,
                                      std::span<const TriangleId> below,
                                      const geometry::Run& run = geometry::Run(), int repairs = 0);

}  // namespace morskin::refine
