#pragma once

/// Whether a triangle list is a closed oriented 2-manifold, and if not, all its defects: each kind
/// counted, its first element named. closed_mesh (glued_triangles.h) stops at the first defect.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::geometry {

enum class MeshDefect {
  NoTriangles,
  RepeatedCorner,        ///< a triangle with a corner twice
  Collinear,             ///< a triangle whose three corners lie on one line, exactly
  DuplicateTriangle,     ///< two triangles with the same three corners
  BoundaryEdge,          ///< an edge with one triangle
  CrowdedEdge,           ///< an edge with three triangles or more
  DisagreeingTriangles,  ///< an edge that both its triangles traverse in the same direction
  SplitVertex,           ///< a vertex where two or more fans of triangles meet
  UnusedVertex,          ///< a vertex without a triangle
};

/// One kind of defect: how often, and the first in words.
struct DefectCount {
  MeshDefect kind;
  std::size_t count = 0;
  std::string first;  ///< "edge 3-7 has only one triangle"
};

/// Triangles joined through edges.
struct MeshComponent {
  std::size_t vertices = 0, edges = 0, triangles = 0;
  std::uint32_t first_triangle = 0;
  bool is_closed_and_oriented = true;  ///< each edge has two triangles, which agree
  double area = 0;                     ///< Angstrom^2
  double volume = 0;  ///< Angstrom^3, negative for a cavity; meaningless unless closed

  /// Of the component with its split vertices separated.
  long euler_characteristic() const {
    return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(triangles);
  }
  /// @pre is_closed_and_oriented
  long genus() const { return 1 - euler_characteristic() / 2; }
};

struct MeshCheck {
  std::vector<DefectCount> defects;       ///< the kinds found, in the order of MeshDefect
  std::vector<MeshComponent> components;  ///< by first triangle
  std::vector<std::uint32_t> component_of_triangle;

  bool is_closed_oriented_manifold() const { return defects.empty(); }
  /// The first defect of a kind, or nothing.
  const DefectCount* find(MeshDefect kind) const;
};

/// O(n), apart from sorting the edges at each vertex.
///
/// @pre every position is finite; fewer than 2^32 / 3 triangles.
MeshCheck check_mesh(const IndexedMesh& mesh);

}  // namespace morskin::geometry
