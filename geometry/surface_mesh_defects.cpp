// What is wrong with the bookkeeping of a mesh, in words.

#include <algorithm>
#include <utility>

#include "geometry/surface_mesh.h"

namespace morskin::geometry {

namespace {

/// Walks round the origin of `first` both ways; the number of triangles met, which falls short of
/// all the triangles with that corner when two sheets touch there.
std::size_t fan_size(const SurfaceMesh& mesh, HalfEdgeId first) {
  std::size_t count = 0;
  HalfEdgeId h = first;
  while (count <= 3 * mesh.triangle_count()) {
    ++count;
    const HalfEdgeId back = SurfaceMesh::previous(h);
    if (mesh.is_boundary(back)) break;
    h = mesh.twin(back);
    if (h == first) return count;
  }
  h = first;
  while (!mesh.is_boundary(h) && count <= 3 * mesh.triangle_count()) {
    h = SurfaceMesh::next(mesh.twin(h));
    ++count;
  }
  return count;
}

}  // namespace

std::string edge_in_words(std::uint32_t a, std::uint32_t b) {
  return "edge " + std::to_string(a) + "-" + std::to_string(b);
}

std::optional<std::string> validate(const SurfaceMesh& mesh, Expect expect) {
  std::vector<std::uint32_t> corners(mesh.vertex_count(), 0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.is_removed(TriangleId{t})) continue;
    const auto [a, b, c] = mesh.corners(TriangleId{t});
    if (a == b || b == c || c == a) return "triangle " + std::to_string(t) + " repeats a corner";
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
      ++corners[mesh.origin(h).index()];
      const std::string edge = edge_in_words(mesh.origin(h).value, mesh.target(h).value);
      if (mesh.is_boundary(h)) {
        if (expect == Expect::Closed) return edge + " has only one triangle";
        continue;
      }
      const HalfEdgeId g = mesh.twin(h);
      if (mesh.is_boundary(g) || mesh.twin(g) != h) return edge + ": its twins are not mutual";
      if (mesh.origin(g) != mesh.target(h) || mesh.target(g) != mesh.origin(h)) {
        return edge + ": its twin runs elsewhere";
      }
    }
  }
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto first = mesh.outgoing(VertexId{v});
    if (!first && corners[v] == 0) continue;
    if (!first) return "vertex " + std::to_string(v) + " has triangles but points to none";
    if (mesh.origin(*first) != VertexId{v}) {
      return "vertex " + std::to_string(v) + " points to a half-edge that does not leave it";
    }
    if (fan_size(mesh, *first) != corners[v]) {
      return "vertex " + std::to_string(v) + " has more than one fan of triangles";
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.is_removed(TriangleId{t})) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
      edges.emplace_back(mesh.origin(h).value, mesh.target(h).value);
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice != edges.end()) return edge_in_words(twice->first, twice->second) + " stands twice";
  return std::nullopt;
}

}  // namespace morskin::geometry
