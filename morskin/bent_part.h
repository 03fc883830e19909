#pragma once

#include "skin/skin_surface.h"

namespace morskin {

/// What the curvature makes of a mesh whose edges are limited by length: where the length scale is
/// below the limit, edges are shorter than asked.
struct BentPart {
  double area_share = 0;        ///< of the area, where the length scale is below the limit
  double triangles = 0;         ///< there
  double forced_triangles = 0;  ///< there about, with circumradii of max_provable_share
};
/// Circumradius over length scale by which meshes are measured: nearly all that the tube of a ball
/// allows, 0.707 (papers/4.3-large-molecules.md). Such a triangle's area is at most 3 sqrt(3) / 4
/// of its square.
inline constexpr double max_provable_share = 0.68;

struct MeshResult;
/// @param result  with the cells of its vertices
BentPart bent_part(const skin::SkinSurface& skin, const MeshResult& result);

}  // namespace morskin
