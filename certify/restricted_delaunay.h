#pragma once

/// Whether a mesh is the restricted Delaunay triangulation of its vertices (section 2.2): no
/// triangle's surface ball (triangle_geometry.h) contains another vertex. All vertices count, not
/// only those of neighbouring triangles.

#include <cstdint>
#include <span>
#include <vector>

#include "certify/delaunay_filter.h"
#include "certify/located_vertices.h"
#include "certify/triangle_geometry.h"
#include "geometry/glued_triangles.h"
#include "geometry/indexed_mesh.h"
#include "geometry/run.h"

namespace morskin::certify {

struct DelaunayViolation {
  std::uint32_t triangle;
  std::uint32_t vertex;  ///< the deepest inside its surface ball
  double depth;          ///< squared radius less squared distance, over the squared radius
};

struct RestrictedDelaunay {
  std::size_t violations = 0;  ///< triangles with a vertex inside their surface ball
  /// Triangles without a surface ball near them, or too large for one; not counted above.
  std::size_t undecided = 0;
  std::size_t exact_balls = 0;             ///< balls computed
  std::vector<DelaunayViolation> deepest;  ///< the deepest first
  std::vector<std::uint32_t> first_undecided;
};

/// @param points   locate_vertices() of the mesh
/// @param listed   length of the lists, at most
/// @pre every position is finite.
RestrictedDelaunay restricted_delaunay(const geometry::IndexedMesh& mesh,
                                       const surface::Surface& surface,
                                       std::span<const SurfacePoint> points,
                                       std::size_t listed = 10,
                                       const geometry::Run& run = geometry::Run());

/// How many triangles have the far corner of a neighbour in their surface ball, by the same rule;
/// of the undecided none.
///
/// Law: in a certified mesh with the default sizing this is 0 exactly if restricted_delaunay()
/// finds no violation. The argument, without its constants: let p lie in the ball of t, and let H
/// be the plane through an edge of t orthogonal to the line of centres of the two balls there. If p
/// is beyond H it lies deeper in the neighbour's ball, so from neighbour to neighbour it gets
/// deeper until it is beyond none of the three planes. There it lies over the triangle, or, since
/// the planes lean, up to some 0.04 R beside it over a neighbour; but the mesh is a graph over the
/// skin (certificate.h), and a vertex lies over no triangle but its own.
/// @param connectivity  the mesh's, closed
/// @param filter        with all triangles noted
std::size_t local_delaunay_violations(const LocatedMesh& on,
                                      const geometry::GluedTriangles& connectivity,
                                      const DelaunayFilter& filter, unsigned threads = 1);

}  // namespace morskin::certify
