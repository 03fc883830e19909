// Taking what was removed out of a mesh's arrays.

#include <cstdint>

#include "geometry/surface_mesh.h"

namespace morskin::geometry {

std::vector<std::optional<VertexId>> SurfaceMesh::compact() {
  Renaming renamed = renaming();
  compact(renamed);
  return std::move(renamed.vertices);
}

SurfaceMesh::Renaming SurfaceMesh::renaming() const {
  Renaming renamed;
  renamed.vertices.resize(vertex_count());
  std::uint32_t vertices = 0;
  for (std::size_t v = 0; v < outgoing_.size(); ++v) {
    if (outgoing_[v] != HalfEdgeId::none()) renamed.vertices[v] = VertexId{vertices++};
  }
  const std::size_t count = triangle_count();
  std::size_t& first = renamed.first_;
  while (first < count && !is_removed(TriangleId{first})) ++first;
  renamed.moved_.resize(count - first, no_index);
  auto triangles = static_cast<std::uint32_t>(first);
  for (std::size_t t = first; t < count; ++t) {
    if (!is_removed(TriangleId{t})) renamed.moved_[t - first] = triangles++;
  }
  renamed.left_ = triangles;
  return renamed;
}

void SurfaceMesh::compact(const Renaming& renaming) {
  // What lies before the first gap stays, and mostly all that it refers to.
  const std::vector<std::optional<VertexId>>& renamed = renaming.vertices;
  const std::size_t count = triangle_count(), first = renaming.first_;
  std::size_t first_vertex = 0;
  while (first_vertex < renamed.size() && renamed[first_vertex]) ++first_vertex;
  const auto place = [&](HalfEdgeId h) { return h == HalfEdgeId::none() ? h : renaming(h); };
  const auto name = [&](VertexId v) { return v.index() < first_vertex ? v : *renamed[v.index()]; };
  for (std::size_t h = 0; h < 3 * first; ++h) {
    HalfEdge& kept = half_edges_[h];
    if (kept.origin.index() >= first_vertex) kept.origin = name(kept.origin);
    if (kept.twin.index() >= 3 * first) kept.twin = place(kept.twin);
  }
  for (std::size_t t = first; t < count; ++t) {
    if (is_removed(TriangleId{t})) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfEdgeId h{3 * t + k};
      const HalfEdge old = half_edges_[h.index()];
      half_edges_[renaming(h).index()] = {name(old.origin), place(old.twin)};
    }
  }
  std::size_t vertices = 0;
  for (std::size_t v = 0; v < renamed.size(); ++v) {
    if (renamed[v]) outgoing_[vertices++] = place(outgoing_[v]);
  }
  outgoing_.resize(vertices);
  half_edges_.resize(3 * renaming.left_);
}

}  // namespace morskin::geometry
