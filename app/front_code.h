#pragma once

/// A triangle mesh in few bytes, for the viewer page: two bits or so for each triangle.
///
/// The decoder builds the mesh as section 4.1 does: it keeps fronts, cycles of edges with the mesh
/// on their left. The code gives for each front edge, in the order of their creation, the case of
/// the triangle beyond. Reader: `viewer/src/front_code.js`.
///
/// With e the front edge from a to b, the triangle beyond it is (b, a, v):
///
///     Border   there is none
///     New      v is a new vertex
///     Next     v is the end of the next front edge, which the triangle closes too
///     Previous v is the start of the one before, which the triangle closes too
///     Both     both of these
///     Touch    v is the start of a front edge elsewhere: the polygon splits, or two join
///     Old      v is an old vertex that no front edge starts from (a mesh that is no manifold)
///
/// When no edge is left the next triangle starts a new front; each of its corners is New or Old.
/// Any triangle list can be encoded, whatever its defects.

#include <cstdint>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::app {

enum class Laid : std::uint8_t { Border, New, Next, Previous, Both, Touch, Old };

/// Vertices and triangles are renumbered in the order of decoding.
struct FrontCode {
  std::vector<std::uint8_t> cases;        ///< of Laid
  std::vector<std::uint32_t> references;  ///< of Touch: ids of edges back from the newest; of Old:
                                          ///< vertices back
  std::vector<std::uint32_t> vertices;    ///< by new number the old one
  std::vector<std::uint32_t> triangles;   ///< by new number the old one
  std::vector<std::uint32_t> parents;     ///< by triangle, the new number of the one it was laid
                                          ///< against; of one that starts a front, the last before
  /// By vertex, the p, q and r that predict it as p + q - r; meaningless for the first vertex.
  std::vector<std::array<std::uint32_t, 3>> predictors;
};

FrontCode front_code(const geometry::TriangleList& triangles, std::size_t vertex_count);

}  // namespace morskin::app
