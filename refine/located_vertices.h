#pragma once

#include <vector>

#include "geometry/indexed_mesh.h"
#include "skin/skin_surface.h"

namespace morskin::refine {

/// For each vertex of any mesh its mixed cell, and the normal and length scale that the skin would
/// have there. Cells are found by walking from a neighbour's, so it is O(n) on ordinary meshes.
std::vector<skin::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                const skin::SkinSurface& skin);

}  // namespace morskin::refine
