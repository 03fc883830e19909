#pragma once

/// Self-intersections of a mesh: pairs of triangles in improper contact (triangle_contact.h), found
/// by a tree of boxes and decided exactly. The order of the search, and so the result, depends on
/// the mesh alone.

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::geometry {

struct SelfIntersections {
  std::size_t count = 0;  ///< at least so many, if the search is incomplete
  /// The first of the pairs counted, ascending, each with the smaller triangle first.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  /// False if the search ended at its limit.
  bool is_complete = true;
};

struct SelfIntersectionLimits {
  std::size_t listed = 100;      ///< pairs listed
  std::size_t counted = 100000;  ///< pairs counted before the search ends
};

/// Ignores triangles with a repeated corner or all corners on one line, which mesh_check counts.
///
/// @pre every position is finite.
SelfIntersections self_intersections(const IndexedMesh& mesh,
                                     const SelfIntersectionLimits& limits = {});

}  // namespace morskin::geometry
