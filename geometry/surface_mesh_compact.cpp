// Taking what was removed out of a mesh's arrays.

#include <cstdint>

#include "geometry/parallel.h"
#include "geometry/surface_mesh.h"

namespace morskin::geometry {

Renaming SurfaceMesh::compact(unsigned threads) {
  const Renaming renamed = renaming();
  do_both(
      threads, [&] { move_elements(renamed); },
      [&] {
        for (MeshFollower* follower : followers_.all) follower->compacted(renamed);
      });
  return renamed;
}

Renaming SurfaceMesh::renaming() const {
  Renaming renamed;
  renamed.vertices.resize(vertex_count());
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    if (outgoing(VertexId{v})) renamed.vertices[VertexId{v}] = VertexId{renamed.vertices_left++};
  }
  const std::size_t count = triangle_count();
  std::size_t& first = renamed.first_;
  while (first < count && !is_removed(TriangleId{first})) ++first;
  renamed.moved_.resize(count - first, no_index);
  auto triangles = static_cast<std::uint32_t>(first);
  for (std::size_t t = first; t < count; ++t) {
    if (!is_removed(TriangleId{t})) renamed.moved_[t - first] = triangles++;
  }
  renamed.triangles_left = triangles;
  return renamed;
}

void SurfaceMesh::move_elements(const Renaming& renamed) {
  // Elements before the first gap stay, and mostly those that they refer to.
  const std::size_t count = triangle_count(), first = renamed.first_;
  std::size_t first_vertex = 0;
  while (first_vertex < vertex_count() && renamed.vertices[VertexId{first_vertex}]) ++first_vertex;
  const auto moved = [&](HalfEdgeId h) { return h == HalfEdgeId::none() ? h : renamed(h); };
  const auto name = [&](VertexId v) { return v.index() < first_vertex ? v : *renamed.vertices[v]; };
  for (std::size_t h = 0; h < 3 * first; ++h) {
    HalfEdge& kept = half_edges_[HalfEdgeId{h}];
    if (kept.origin.index() >= first_vertex) kept.origin = name(kept.origin);
    if (kept.twin.index() >= 3 * first) kept.twin = moved(kept.twin);
  }
  for (std::size_t t = first; t < count; ++t) {
    if (is_removed(TriangleId{t})) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = half_edge(TriangleId{t}, k);
      const HalfEdge old = half_edges_[h];
      half_edges_[renamed(h)] = {name(old.origin), moved(old.twin)};
    }
  }
  for (std::size_t v = 0; v < renamed.vertices.size(); ++v) {
    if (const auto kept = renamed.vertices[VertexId{v}]) {
      outgoing_[*kept] = moved(outgoing_[VertexId{v}]);
    }
  }
  outgoing_.resize(renamed.vertices_left);
  half_edges_.resize(3 * renamed.triangles_left);
}

}  // namespace morskin::geometry
