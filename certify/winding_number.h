#pragma once

#include <span>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::certify {

/// How often a closed mesh winds round each of some points: 1 inside what it bounds, 0 outside.
/// Exact.
///
/// The triangles above a point are counted, +1 where they face upwards, -1 downwards. A vertical
/// line through an edge or a vertex passes to one side of it, the same for all its triangles.
/// @pre all coordinates are finite, and no point lies on the mesh
std::vector<int> winding_numbers(const geometry::IndexedMesh& mesh,
                                 std::span<const geometry::Point> points);

}  // namespace morskin::certify
