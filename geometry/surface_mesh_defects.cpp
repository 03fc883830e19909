// What is wrong with a mesh, in words, and meshes from lists of triangles where nothing is.

#include <algorithm>
#include <utility>

#include "geometry/surface_mesh.h"

namespace morskin::geometry {

namespace {

std::string edge_text(std::uint32_t a, std::uint32_t b) {
  return "edge " + std::to_string(a) + "-" + std::to_string(b);
}

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

std::optional<std::string> validate(const SurfaceMesh& mesh, Expect expect) {
  std::vector<std::uint32_t> corners(mesh.vertex_count(), 0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.is_removed(TriangleId{t})) continue;
    const auto [a, b, c] = mesh.corners(TriangleId{t});
    if (a == b || b == c || c == a) return "triangle " + std::to_string(t) + " repeats a corner";
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
      ++corners[mesh.origin(h).index()];
      const std::string edge = edge_text(mesh.origin(h).value, mesh.target(h).value);
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
  if (twice != edges.end()) return edge_text(twice->first, twice->second) + " stands twice";
  return std::nullopt;
}

namespace {

/// Glues each half-edge to its opposite. While a half-edge waits for its twin it stands in a list
/// at the end that has fewer triangles. Lists so stay short even where one vertex is in all
/// triangles, and this is O(n) for every mesh on a surface of little genus.
/// @return whether none is left waiting.
bool glue_all(SurfaceMesh& mesh) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  const std::size_t count = 3 * mesh.triangle_count();
  std::vector<std::uint32_t> first(mesh.vertex_count(), none), next(count, none);
  std::vector<std::uint32_t> triangles(mesh.vertex_count(), 0);
  for (std::uint32_t h = 0; h < count; ++h) ++triangles[mesh.origin(HalfEdgeId{h}).index()];
  std::size_t waiting = 0;
  for (std::uint32_t h = 0; h < count; ++h) {
    const VertexId a = mesh.origin(HalfEdgeId{h}), b = mesh.target(HalfEdgeId{h});
    const bool is_at_a = std::pair(triangles[a.index()], a) < std::pair(triangles[b.index()], b);
    std::uint32_t& list = first[is_at_a ? a.index() : b.index()];
    std::uint32_t* link = &list;
    while (*link != none &&
           (mesh.target(HalfEdgeId{*link}) != a || mesh.origin(HalfEdgeId{*link}) != b)) {
      link = &next[*link];
    }
    if (*link == none) {
      next[h] = std::exchange(list, h);
      ++waiting;
    } else {
      mesh.glue(HalfEdgeId{h}, HalfEdgeId{std::exchange(*link, next[*link])});
      --waiting;
    }
  }
  return waiting == 0;
}

/// Why some half-edge has no twin, in words: for the first edge that lacks one.
std::string gluing_defect(const SurfaceMesh& mesh) {
  const std::size_t count = 3 * mesh.triangle_count();
  std::uint32_t lonely = 0;
  while (!mesh.is_boundary(HalfEdgeId{lonely})) ++lonely;
  const VertexId a = mesh.origin(HalfEdgeId{lonely}), b = mesh.target(HalfEdgeId{lonely});
  std::size_t same = 0, opposite = 0;
  for (std::uint32_t h = 0; h < count; ++h) {
    const VertexId p = mesh.origin(HalfEdgeId{h}), q = mesh.target(HalfEdgeId{h});
    same += p == a && q == b;
    opposite += p == b && q == a;
  }
  const std::string edge = edge_text(a.value, b.value);
  if (same + opposite == 1) return edge + " has only one triangle";
  if (same + opposite > 2) return edge + " has more than two triangles";
  return edge + ": its triangles disagree on orientation";
}

/// How many triangles a walk round a vertex meets, and whether two of its edges lead to the same
/// neighbour; `seen` is scratch, by vertex.
struct Round {
  std::size_t triangles = 0;
  bool has_double_edge = false;
};
Round walk_round(const SurfaceMesh& mesh, VertexId v, std::vector<std::uint32_t>& seen) {
  Round round;
  mesh.for_each_outgoing(v, [&](HalfEdgeId h) {
    ++round.triangles;
    round.has_double_edge |= std::exchange(seen[mesh.target(h).index()], v.value) == v.value;
  });
  return round;
}

/// What is wrong at the first vertex that is not in the middle of one fan of triangles.
std::optional<std::string> fan_defect(const SurfaceMesh& mesh) {
  const auto text = [](std::size_t v, const char* what) {
    return "vertex " + std::to_string(v) + what;
  };
  std::vector<std::uint32_t> seen(mesh.vertex_count(), 0xFFFFFFFFU);
  std::optional<std::string> defect;
  std::size_t met = 0, walked = 0;
  for (; walked < mesh.vertex_count() && !defect; ++walked) {
    const VertexId v{walked};
    if (!mesh.outgoing(v)) return text(walked, " belongs to no triangle");
    const Round round = walk_round(mesh, v, seen);
    met += round.triangles;
    if (round.has_double_edge) defect = text(walked, " is joined twice to a neighbour");
  }
  // Each walk met one fan; all together met every corner, unless some vertex has two fans.
  if (met == 3 * mesh.triangle_count()) return defect;
  std::vector<std::size_t> corners(mesh.vertex_count(), 0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (const VertexId v : mesh.corners(TriangleId{t})) ++corners[v.index()];
  }
  for (std::size_t v = 0; v < walked; ++v) {
    if (mesh.degree(VertexId{v}) != corners[v]) return text(v, " is where two sheets touch");
  }
  return defect;
}

}  // namespace

MeshOrDefect closed_mesh(std::size_t vertices,
                         const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  MeshOrDefect result;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    if (a == b || b == c || c == a) {
      result.defect = "triangle " + std::to_string(t) + " repeats a corner";
      return result;
    }
  }
  result.mesh = SurfaceMesh(vertices, triangles);
  if (glue_all(result.mesh)) {
    result.defect = fan_defect(result.mesh);
  } else {
    result.defect = gluing_defect(result.mesh);
  }
  return result;
}

}  // namespace morskin::geometry
