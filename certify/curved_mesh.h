#pragma once

/// What is proved of a mesh with curved triangles beyond the certificate of its corners.
/// papers/second-order.md.

#include <cstddef>
#include <optional>
#include <string>

#include "certify/curved_triangle.h"
#include "certify/residuals.h"
#include "geometry/run.h"
#include "geometry/second_order_mesh.h"
#include "surface/surface.h"

namespace morskin::certify {

CurvedTriangle nodes_of(const geometry::SecondOrderMesh& mesh,
                        const geometry::SecondOrderTriangle& triangle);

struct CurvedMeasures {
  double area = 0;                            ///< Angstrom^2
  double least_jacobian = 1;                  ///< of the triangles that are proved regular
  std::optional<std::size_t> first_unproved;  ///< a triangle that is not
};

CurvedMeasures measure_curved(const geometry::SecondOrderMesh& mesh);

/// Why the nodes in edges do not fit the edges: the triangles at an edge have two nodes, two edges
/// have one, or a node is no nearer to the middle of its edge than the ends are. Empty if they do.
/// Then the curved triangles are glued as the flat ones are.
std::string objection_to_nodes(const geometry::SecondOrderMesh& mesh);

/// How far the nodes in edges lie from the surface. The number of one is counted among all nodes.
/// @param vertices  of the flat mesh, which the nodes begin with
Residuals node_residuals(const geometry::SecondOrderMesh& mesh, std::size_t vertices,
                         const surface::Surface& surface, const geometry::Run& run);

}  // namespace morskin::certify
