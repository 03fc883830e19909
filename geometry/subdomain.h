#pragma once

/// What one of several may touch while others work on the rest of a mesh.
///
/// Each vertex belongs to one part or to none. A triangle belongs to the part that contains all
/// three corners, so all triangles at a vertex belong to the vertex's part or to none: that part
/// may read them, and walk from one to the next over an edge of which it contains an end.

#include <atomic>
#include <bit>
#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/dissection.h"
#include "geometry/id_vector.h"
#include "geometry/parallel.h"
#include "geometry/surface_mesh.h"

namespace morskin::geometry {

using Part = std::uint8_t;
inline constexpr Part no_part = 255;    ///< of vertices that belong to none
inline constexpr Part max_parts = 127;  ///< leaves room for what each has given up
using Parts = IdVector<VertexId, Part>;

class Subdomain {
 public:
  /// The whole mesh, with no other at work.
  Subdomain() = default;
  /// @param parts  must outlive this, and have as many elements as the mesh has vertices
  /// @param own    below max_parts
  Subdomain(Parts& parts, Part own) : parts_(&parts), own_(own) {}

  bool is_whole() const { return parts_ == nullptr; }
  bool contains(VertexId v) const { return is_whole() || part_of(v) == own_; }
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
  /// Whether no other may touch v: it may be read. The same whatever others have given up.
  bool is_safe_to_read(VertexId v) const {
    if (is_whole()) return true;
    const Part part = part_of(v);
    return part == own_ || part == given_up() || part == no_part;
  }
  /// Touches v no longer.
  void give_up(VertexId v) {
    if (!is_whole() && contains(v)) std::atomic_ref((*parts_)[v]).store(given_up(), relaxed);
  }

 private:
  static constexpr auto relaxed = std::memory_order_relaxed;

  Part given_up() const { return static_cast<Part>(max_parts + own_); }
  // Others may ask about v while its part gives it up.
  Part part_of(VertexId v) const { return std::atomic_ref((*parts_)[v]).load(relaxed); }

  Parts* parts_ = nullptr;
  Part own_ = 0;
};

/// The part that a triangle belongs to, or no_part.
inline Part part_of(const SurfaceMesh& mesh, const Parts& parts, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return parts[a] == parts[b] && parts[b] == parts[c] ? parts[a] : no_part;
}

/// Cuts space into boxes with like shares of a mesh's vertices, and shares these out: each box gets
/// those in it of which all neighbours are in it too.
/// @param boxes     a power of two, at most max_parts
/// @param position  VertexId -> Point
/// @pre the mesh is closed
template <class Position>
Parts parts_by_boxes(const SurfaceMesh& mesh, std::size_t boxes, Position position,
                     unsigned threads) {
  assert(std::has_single_bit(boxes) && boxes <= max_parts);
  const std::size_t count = mesh.vertex_count();
  constexpr std::size_t samples_to_each = 256;
  std::vector<Point> samples;
  for (std::size_t v = 0; v < count; v += count / (boxes * samples_to_each) + 1) {
    if (mesh.outgoing(VertexId{v})) samples.push_back(position(VertexId{v}));
  }
  const Dissection dissection(std::move(samples), static_cast<int>(std::bit_width(boxes)) - 1);

  Parts box(count, no_part);
  for_each_block(threads, count, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t v = begin; v < end; ++v) {
      const Point& x = position(VertexId{v});
      box[VertexId{v}] = static_cast<Part>(dissection.box_of(x, dissection.first_leaf()) -
                                           dissection.first_leaf());
    }
  });
  Parts parts = box;
  const auto divide = [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const TriangleId t{i};
      if (mesh.is_removed(t) || part_of(mesh, box, t) != no_part) continue;
      for (const VertexId v : mesh.corners(t)) {
        std::atomic_ref(parts[v]).store(no_part, std::memory_order_relaxed);
      }
    }
  };
  for_each_block(threads, mesh.triangle_count(), divide);
  return parts;
}

}  // namespace morskin::geometry
