#pragma once

/// Self-intersections of a mesh: pairs of triangles in improper contact (triangle_contact.h), found
/// with a tree of boxes and decided exactly.

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::geometry {

struct SelfIntersections {
  std::size_t count = 0;
  /// The first of them, each with the smaller triangle first, ascending.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  /// False if the search ended at the most that it was to count.
  bool is_complete = true;
};

struct SelfIntersectionLimits {
  std::size_t listed = 100;       ///< how many pairs are kept
  std::size_t counted = 1 << 20;  ///< where the search ends
};

/// Triangles with a repeated corner or all corners on one line take no part: they are no surface,
/// and mesh_check counts them.
///
/// @pre every position is finite.
SelfIntersections self_intersections(const IndexedMesh& mesh,
                                     const SelfIntersectionLimits& limits = {});

}  // namespace morskin::geometry
