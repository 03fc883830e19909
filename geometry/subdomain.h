#pragma once

/// What one of several may touch while others work on the rest of a mesh.
///
/// Each vertex belongs to one part or to none. A triangle belongs to the part that contains all
/// three corners, so all triangles at a vertex belong to the vertex's part or to none: that part
/// may read them, and walk from one to the next over an edge of which it contains an end.

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "geometry/id_vector.h"
#include "geometry/surface_mesh.h"

namespace morskin::geometry {

using Part = std::uint8_t;
inline constexpr Part no_part = 255;  ///< of vertices that belong to none
using Parts = IdVector<VertexId, Part>;

class Subdomain {
 public:
  /// The whole mesh, with no other at work.
  Subdomain() = default;
  /// @param parts  must outlive this, and have as many elements as the mesh has vertices
  Subdomain(Parts& parts, Part own) : parts_(&parts), own_(own) {}

  bool is_whole() const { return parts_ == nullptr; }
  bool contains(VertexId v) const { return is_whole() || (*parts_)[v] == own_; }
  bool contains(const SurfaceMesh& mesh, TriangleId t) const {
    const auto [a, b, c] = mesh.corners(t);
    return contains(a) && contains(b) && contains(c);
  }
  /// Whether it contains v and all neighbours of v, which then has no boundary.
  bool contains_star(const SurfaceMesh& mesh, VertexId v) const {
    if (is_whole()) return true;
    if (!contains(v)) return false;
    bool has_all = true;
    mesh.for_each_outgoing(v, [&](HalfEdgeId h) { has_all &= contains(mesh.target(h)); });
    return has_all;
  }
  /// Whether no other may touch v: it may be read.
  bool is_safe_to_read(VertexId v) const { return contains(v) || (*parts_)[v] == no_part; }
  /// Touches v no longer. @pre no other reads these parts at the same time, and not the whole mesh
  void give_up(VertexId v) {
    if (contains(v)) (*parts_)[v] = no_part;
  }

 private:
  Parts* parts_ = nullptr;
  Part own_ = 0;
};

/// Shares the vertices of a mesh out among blocks of consecutive triangles: each block gets those
/// that are corners of no other's.
/// @param size  of a block; there may be 254 blocks
inline Parts parts_by_blocks(const SurfaceMesh& mesh, std::size_t size) {
  constexpr Part unseen = no_part - 1;
  assert(mesh.triangle_count() <= size * unseen);
  Parts parts(mesh.vertex_count(), unseen);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.is_removed(TriangleId{t})) continue;
    const auto block = static_cast<Part>(t / size);
    for (const VertexId v : mesh.corners(TriangleId{t})) {
      if (parts[v] != block) parts[v] = parts[v] == unseen ? block : no_part;
    }
  }
  std::ranges::replace(parts, unseen, no_part);
  return parts;
}

}  // namespace morskin::geometry
