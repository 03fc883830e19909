#pragma once

/// What was done to a mesh, so that it can be taken back: a trial that does not help leaves no
/// trace but the ids of some triangles.

#include <vector>

#include "refine/names.h"

namespace morskin::refine {

class Journal {
 public:
  explicit Journal(Mesh& mesh) : mesh_(mesh) {}

  /// After an edge was flipped.
  void note_flip(HalfEdgeId h);
  /// After a vertex came into a triangle, the corners still around it.
  void note_insertion(VertexId v);
  /// After a vertex was taken out.
  /// @param left  the triangle that was left when it had three neighbours
  void note_removal(VertexId v, const SurfacePoint& point, TriangleId left);
  /// Before or after a vertex was moved.
  void note_move(VertexId v, const SurfacePoint& from);

  std::size_t size() const { return changes_.size(); }
  /// How many vertices were taken out and put in, all told.
  std::size_t exchanged() const;
  /// Takes all changes back but the first ones.
  /// @param free_slots  of the vertices removed, the last at the end; those of vertices inserted
  ///                    are added
  void undo(std::size_t first, std::vector<SurfaceMesh::FreeSlots>& free_slots);
  void clear() { changes_.clear(); }
  /// In order, each once, the vertices there are whose triangles changed.
  std::vector<VertexId> touched(std::size_t first = 0) const;

 private:
  enum class Kind { Flip, Insertion, Removal, Move };
  struct Change {
    Kind kind;
    /// Flip: the ends of the edge as it is, then as it was. Insertion and removal: the vertex, then
    /// the triangle. Move: the vertex.
    std::array<VertexId, 4> vertices;
    SurfacePoint point;  ///< of a vertex removed or moved, before
  };

  Mesh& mesh_;
  std::vector<Change> changes_;
};

}  // namespace morskin::refine
