#pragma once

/// Whether a mesh is the restricted Delaunay triangulation of its vertices (section 2.2): each
/// triangle's surface ball (triangle_geometry.h) has no other vertex inside. All vertices are
/// asked, through a tree, not only those of neighbouring triangles.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "refine/triangle_geometry.h"

namespace morskin::refine {

/// A vertex counts as inside a ball when it is deeper than this share of the squared radius (the
/// refinement's own margin, so that four vertices on a circle settle either way), and deeper than
/// rounding.
inline constexpr double least_intrusion = 1e-9;

struct DelaunayViolation {
  std::uint32_t triangle;
  std::uint32_t vertex;  ///< the deepest inside its surface ball
  double depth;          ///< squared radius less squared distance, over the squared radius
};

struct RestrictedDelaunay {
  std::size_t violations = 0;   ///< triangles with a vertex inside their surface ball
  std::size_t undecided = 0;    ///< triangles without a surface ball near them; not counted above
  std::size_t exact_balls = 0;  ///< how many had to be computed
  std::vector<DelaunayViolation> deepest;  ///< by depth, the worst first
  std::vector<std::uint32_t> first_undecided;
};

/// @param points   locate_vertices() of the mesh
/// @param listed   how many violations are kept
/// @param threads  how many may be used; the result is the same for any number
/// @pre every position is finite.
RestrictedDelaunay restricted_delaunay(const geometry::IndexedMesh& mesh,
                                       const skin::SkinSurface& skin,
                                       std::span<const SurfacePoint> points,
                                       std::size_t listed = 10, unsigned threads = 1);

}  // namespace morskin::refine
