#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/id.h"
#include "geometry/id_vector.h"

namespace morskin::geometry {

using HalfEdgeId = Id<struct HalfEdgeTag>;
class SurfaceMesh;

/// The new ids of what stays when a mesh is compacted, in the old order.
class Renaming {
 public:
  IdVector<VertexId, std::optional<VertexId>> vertices;  ///< by old vertex; nothing where it goes
  std::size_t vertices_left = 0, triangles_left = 0;

  bool is_removed(TriangleId t) const {
    return t.index() >= first_ && moved_[t.index() - first_] == no_index;
  }
  /// @pre the triangle stays.
  TriangleId operator()(TriangleId t) const {
    return t.index() < first_ ? t : TriangleId{moved_[t.index() - first_]};
  }
  HalfEdgeId operator()(HalfEdgeId h) const {
    const TriangleId t{h.value / 3};
    return t.index() < first_ ? h : HalfEdgeId{3 * (*this)(t).value + h.value % 3};
  }

 private:
  friend class SurfaceMesh;
  std::size_t first_ = 0;             ///< triangles before this one keep their ids
  std::vector<std::uint32_t> moved_;  ///< by triangle from there on, its new id or no_index
};

/// Something that refers to the elements of a mesh and is kept true while the mesh changes. A flip
/// changes no id, so followers receive none.
///
/// It follows the mesh object that it was made for, whatever is assigned to that. Copies of the
/// mesh have no followers.
class MeshFollower {
 public:
  MeshFollower(const MeshFollower&) = delete;
  MeshFollower& operator=(const MeshFollower&) { return *this; }  // follows what it followed

 protected:
  /// @param has_triangles  whether it follows every new triangle
  explicit MeshFollower(SurfaceMesh& mesh, bool has_triangles = false);
  virtual ~MeshFollower();
  /// @pre the mesh lives.
  const SurfaceMesh& followed() const { return *mesh_; }

 private:
  friend class SurfaceMesh;
  /// The mesh is about to have so many vertices and twice as many triangles.
  virtual void reserved(std::size_t /*vertices*/) {}
  /// The mesh has so many vertices now. New ones have the highest ids.
  virtual void vertices_resized(std::size_t) {}
  /// The same of triangles.
  virtual void triangles_resized(std::size_t) {}
  /// A vertex has gone. Its id may come back for another.
  virtual void vertex_removed(VertexId) {}
  /// A triangle was split at a new vertex and keeps its id; two more came to be. Called by several
  /// threads at once for triangles that share no corner with another thread's.
  virtual void triangle_split(TriangleId /*first*/, TriangleId /*second*/, TriangleId /*third*/) {}
  /// The mesh is compacted, perhaps at this moment by another thread.
  virtual void compacted(const Renaming&) {}
  /// Another mesh is appended.
  /// @param other      what follows it and was made in the same turn; nullptr if there is none. It
  ///                   is not needed afterwards.
  /// @param vertices, triangles  of both together
  virtual void appended(MeshFollower* /*other*/, std::size_t vertices, std::size_t triangles) {
    vertices_resized(vertices);
    triangles_resized(triangles);
  }

  SurfaceMesh* mesh_;  ///< nullptr when it is gone
};

}  // namespace morskin::geometry
