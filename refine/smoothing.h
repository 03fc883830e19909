#pragma once

/// Smoothing: brings the angles of a refined mesh to a goal by moving vertices along the skin. Not
/// in the paper, whose [L] and [U] bound the angles and leave the rest to chance.
///
/// Only vertices of triangles that miss the goal are moved, one at a time, to where the worst of
/// the triangles around them is nearer to it. A move that breaks [L] or [U], turns a triangle over
/// or lets a vertex into a surface ball is not made. So the connectivity stays, the worst triangle
/// around a moved vertex is always better than before, and every law of the refined mesh still
/// holds. That the goal is reached is not proved; how often it is, is measured
/// (papers/4.3-local-refinement.md).

#include <cstddef>
#include <vector>

#include "geometry/run.h"
#include "refine/angle_goal.h"

namespace morskin::refine {

struct SmoothingCounts {
  std::size_t below = 0;         ///< triangles that miss the goal, before
  std::size_t moved = 0;         ///< moves of a vertex
  std::vector<TriangleId> left;  ///< triangles that miss the goal, after
};

/// Triangles are gone through in the order of their ids, in a large mesh box by box, several boxes
/// at a time, with what lies at the borders of boxes last.
///
/// @param least_to_each  triangles to each box
/// @pre the mesh is closed and compact, its vertices are points of the skin.
SmoothingCounts smooth(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                       const AngleGoal& goal, const geometry::Run& run = geometry::Run(),
                       std::size_t least_to_each = std::size_t{1} << 14);

}  // namespace morskin::refine
