#pragma once

/// A certified mesh with curved triangles: its vertices stay, and each edge gets a node near its
/// middle, on the skin. papers/second-order.md.

#include <cstdint>
#include <span>
#include <vector>

#include "certify/curved_mesh.h"
#include "geometry/indexed_mesh.h"
#include "geometry/second_order_mesh.h"
#include "surface/surface.h"

namespace morskin {

struct SecondOrder {
  geometry::SecondOrderMesh mesh;
  std::vector<geometry::CellId> cells;  ///< by node, vertices first
  std::vector<std::uint32_t> ends;      ///< by node in an edge, a vertex of the edge
  certify::CurvedMeasures measures;
};

/// From the middle of each edge, or an eighth of its half beside it at most, a node goes along the
/// gradient onto the surface: so that the parabola over the edge fits the surface at both ends.
/// Nodes of triangles that are not proved regular then come from the middles themselves.
/// @param cells  by vertex, the cell that it lies in
/// @throws geometry::RefusedInput  a triangle whose Jacobian is not proved positive, an edge whose
///         middle does not reach the surface, or objection_to_nodes(); it names the first of them
SecondOrder second_order(const surface::Surface& surface, const geometry::IndexedMesh& mesh,
                         std::span<const geometry::CellId> cells);

}  // namespace morskin
