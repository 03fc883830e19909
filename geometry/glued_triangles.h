#pragma once

/// Lists of triangles that are glued to closed meshes, or the first reason why they are none.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/surface_mesh.h"

namespace morskin::geometry {

/// The connectivity of a list of triangles that stays as it is: in half of the memory that a
/// SurfaceMesh takes, for the corners are the list's own. Half-edges are numbered as there.
class GluedTriangles {
 public:
  GluedTriangles() = default;
  /// None is glued to another yet.
  /// @param triangles  must outlive this
  /// @pre every corner is below `vertices`; at most max_triangles.
  GluedTriangles(std::size_t vertices, std::span<const TriangleCorners> triangles);

  /// Glued by hinted twins, which are checked: nothing unless each edge is between two triangles
  /// that agree on orientation.
  /// @param twins  by half-edge; any size, any values
  static std::optional<GluedTriangles> by_twins(std::size_t vertices,
                                                std::span<const TriangleCorners> triangles,
                                                std::vector<HalfEdgeId> twins);

  std::size_t vertex_count() const { return outgoing_.size(); }
  std::size_t triangle_count() const { return triangles_.size(); }

  VertexId origin(HalfEdgeId h) const { return VertexId{triangles_[h.value / 3][h.value % 3]}; }
  VertexId target(HalfEdgeId h) const { return origin(SurfaceMesh::next(h)); }
  VertexId apex(HalfEdgeId h) const { return origin(SurfaceMesh::previous(h)); }
  bool is_boundary(HalfEdgeId h) const { return twins_[h.index()] == HalfEdgeId::none(); }
  /// @pre !is_boundary(h)
  HalfEdgeId twin(HalfEdgeId h) const { return twins_[h.index()]; }
  /// By half-edge its twin, or the last id of all for none.
  const std::vector<HalfEdgeId>& twins() const { return twins_; }
  /// A half-edge that leaves v, or the last id of all for a vertex without triangles.
  HalfEdgeId outgoing(VertexId v) const { return outgoing_[v]; }
  /// As SurfaceMesh::prefetch_fan().
  void prefetch_fan(VertexId v) const {
    const HalfEdgeId first = outgoing_[v];
    if (first == HalfEdgeId::none()) return;
    prefetch(&twins_[first.index()]);
    prefetch(&triangles_[first.value / 3]);
  }
  /// As SurfaceMesh::for_each_outgoing().
  template <class Visit>
  void for_each_outgoing(VertexId v, Visit visit) const {
    const HalfEdgeId first = outgoing_[v];
    HalfEdgeId h = first;
    do {
      visit(h);
      h = twin(SurfaceMesh::previous(h));
    } while (h != first);
  }

  /// Makes two boundary half-edges each other's twin.
  /// @pre they run between the same vertices, oppositely.
  void glue(HalfEdgeId h, HalfEdgeId g) {
    twins_[h.index()] = g;
    twins_[g.index()] = h;
  }

 private:
  void name_outgoing();

  std::span<const TriangleCorners> triangles_;
  std::vector<HalfEdgeId> twins_;
  IdVector<VertexId, HalfEdgeId> outgoing_;
};

/// Triangles glued to their neighbours, or the first reason why they are no closed oriented
/// 2-manifold: an edge with one triangle or three, two triangles that disagree on orientation, a
/// vertex where two sheets touch. O(n), but for O(n log n) where a vertex or an edge is crowded.
template <class Connectivity>
struct OrDefect {
  Connectivity mesh;
  std::optional<std::string> defect;
};
/// @param triangles  must outlive the result
OrDefect<GluedTriangles> closed_triangles(std::size_t vertices, const TriangleList& triangles);
OrDefect<SurfaceMesh> closed_mesh(std::size_t vertices, const TriangleList& triangles);

/// The same in two steps. First edges: each triangle glued to its neighbours, or the first edge
/// without two triangles that agree.
OrDefect<GluedTriangles> glued_triangles(std::size_t vertices, const TriangleList& triangles);
/// Then vertices: what is wrong at the first that is not in the middle of one fan of triangles,
/// with as many neighbours.
/// @param threads  at most; the answer is the same for any number
/// @pre no boundary
std::optional<std::string> fan_defect(const GluedTriangles& mesh, unsigned threads = 1);

}  // namespace morskin::geometry
