#include "geometry/surface_mesh.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/error.h"
#include "geometry/union_find.h"

namespace morskin::geometry {

SurfaceMesh::SurfaceMesh(std::size_t vertices,
                         std::span<const std::array<std::uint32_t, 3>> triangles)
    : half_edges_(3 * triangles.size()), outgoing_(vertices, HalfEdgeId{kBoundary}) {
  if (triangles.size() > most_triangles) fail_for_lack_of_ids(most_triangles, "triangles");
  HalfEdgeId h;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) {
      set_corner(h, VertexId{v});
      ++h.value;
    }
  }
}

void SurfaceMesh::reserve(std::size_t vertices) {
  outgoing_.reserve(vertices);
  half_edges_.reserve(6 * vertices);
}

std::optional<HalfEdgeId> SurfaceMesh::outgoing(VertexId v) const {
  const HalfEdgeId h = outgoing_[v.index()];
  return h.value == kBoundary ? std::nullopt : std::optional(h);
}

VertexId SurfaceMesh::add_vertex() {
  outgoing_.emplace_back(kBoundary);
  return VertexId{outgoing_.size() - 1};
}

TriangleId SurfaceMesh::add_triangle(VertexId a, VertexId b, VertexId c) {
  assert(a != b && b != c && c != a);
  require_room(half_edges_.size() / 3, most_triangles, "triangles");
  const HalfEdgeId first{half_edges_.size()};
  half_edges_.push_back({a, HalfEdgeId{kBoundary}});
  half_edges_.push_back({b, HalfEdgeId{kBoundary}});
  half_edges_.push_back({c, HalfEdgeId{kBoundary}});
  outgoing_[a.index()] = first;
  outgoing_[b.index()] = HalfEdgeId{first.value + 1};
  outgoing_[c.index()] = HalfEdgeId{first.value + 2};
  return triangle(first);
}

void SurfaceMesh::glue(HalfEdgeId h, HalfEdgeId g) {
  assert(is_boundary(h) && is_boundary(g));
  assert(origin(h) == target(g) && origin(g) == target(h));
  set_twin(h, g);
}

void SurfaceMesh::append(const SurfaceMesh& other) {
  const std::uint32_t vertices = static_cast<std::uint32_t>(vertex_count());
  const std::uint32_t half_edges = static_cast<std::uint32_t>(half_edges_.size());
  const auto moved = [](auto id, std::uint32_t by) {
    return id.value == kBoundary ? id : decltype(id){id.value + by};
  };
  if (triangle_count() + other.triangle_count() > most_triangles) {
    fail_for_lack_of_ids(most_triangles, "triangles");
  }
  // A little more than the whole: refinement adds vertices, and growing would double the arrays.
  constexpr std::size_t share_to_come = 16;
  const std::size_t vertices_together = vertex_count() + other.vertex_count();
  reserve(vertices_together + vertices_together / share_to_come);
  for (const HalfEdge& h : other.half_edges_) {
    half_edges_.push_back({moved(h.origin, vertices), moved(h.twin, half_edges)});
  }
  for (const HalfEdgeId h : other.outgoing_) outgoing_.push_back(moved(h, half_edges));
}

void SurfaceMesh::flip(HalfEdgeId h) {
  assert(!is_boundary(h));
  const HalfEdgeId g = twin(h);
  const VertexId a = origin(h), b = origin(g), c = apex(h), d = apex(g);
  const HalfEdgeId beyond_bc = half_edges_[next(h).index()].twin,
                   beyond_ca = half_edges_[previous(h).index()].twin;
  const HalfEdgeId beyond_ad = half_edges_[next(g).index()].twin,
                   beyond_db = half_edges_[previous(g).index()].twin;
  set_corner(previous(h), a);
  set_corner(previous(g), b);
  set_corner(next(h), c);
  set_corner(g, c);
  set_corner(next(g), d);
  set_corner(h, d);
  set_twin(next(h), beyond_ca);
  set_twin(previous(h), beyond_ad);
  set_twin(next(g), beyond_db);
  set_twin(previous(g), beyond_bc);
}

void SurfaceMesh::split(TriangleId t, VertexId v) {
  const auto [a, b, c] = corners(t);
  const HalfEdgeId ab = half_edge(t, 0);
  const HalfEdgeId beyond_bc = half_edges_[next(ab).index()].twin,
                   beyond_ca = half_edges_[previous(ab).index()].twin;
  const HalfEdgeId bc = half_edge(add_triangle(b, c, v), 0);
  const HalfEdgeId ca = half_edge(add_triangle(c, a, v), 0);
  set_corner(previous(ab), v);
  set_corner(ab, a);
  set_corner(next(ab), b);
  set_twin(bc, beyond_bc);
  set_twin(ca, beyond_ca);
  set_twin(next(ab), previous(bc));
  set_twin(next(bc), previous(ca));
  set_twin(next(ca), previous(ab));
}

void SurfaceMesh::unsplit(VertexId v) {
  assert(degree(v) == 3);
  const HalfEdgeId va = outgoing_[v.index()];
  const HalfEdgeId vb = twin(previous(va));
  const HalfEdgeId vc = twin(previous(vb));
  const HalfEdgeId beyond_bc = half_edges_[next(vb).index()].twin,
                   beyond_ca = half_edges_[next(vc).index()].twin;
  const VertexId a = target(va), b = target(vb), c = target(vc);
  // The kept triangle's half-edges va, next(va), previous(va) become c-a, a-b, b-c.
  set_corner(va, c);
  set_corner(next(va), a);
  set_corner(previous(va), b);
  set_twin(va, beyond_ca);
  set_twin(previous(va), beyond_bc);
  for (const HalfEdgeId h : {vb, vc}) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      half_edges_[half_edge(triangle(h), k).index()] = {};
    }
  }
  outgoing_[v.index()] = HalfEdgeId{kBoundary};
}

void SurfaceMesh::remove(std::span<const TriangleId> triangles) {
  for (const TriangleId t : triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      outgoing_[half_edges_[half_edge(t, k).index()].origin.index()] = HalfEdgeId{kBoundary};
    }
  }
  for (const TriangleId t : triangles) {
    for (std::uint32_t k = 0; k < 3; ++k)
      half_edges_[half_edge(t, k).index()].origin = VertexId{kBoundary};
  }
  // A fan that is left begins at the half-edge whose twin is gone.
  for (const TriangleId t : triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      HalfEdgeId& twin = half_edges_[half_edge(t, k).index()].twin;
      if (twin.value != kBoundary && half_edges_[twin.index()].origin.value != kBoundary) {
        half_edges_[twin.index()].twin = HalfEdgeId{kBoundary};
        outgoing_[half_edges_[twin.index()].origin.index()] = twin;
      }
      twin = HalfEdgeId{kBoundary};
    }
  }
}

std::size_t SurfaceMesh::degree(VertexId v) const {
  std::size_t count = 0;
  for_each_outgoing(v, [&](HalfEdgeId) { ++count; });
  return count;
}

bool SurfaceMesh::has_edge(VertexId a, VertexId b) const {
  bool found = false;
  for_each_outgoing(a, [&](HalfEdgeId h) { found = found || target(h) == b; });
  return found;
}

std::vector<std::optional<VertexId>> SurfaceMesh::compact() {
  std::vector<std::optional<VertexId>> renamed(vertex_count());
  std::vector<HalfEdgeId> moved(half_edges_.size(), HalfEdgeId{kBoundary});
  std::size_t vertices = 0, half_edges = 0;
  for (std::size_t v = 0; v < outgoing_.size(); ++v) {
    if (outgoing_[v].value != kBoundary) renamed[v] = VertexId{vertices++};
  }
  for (std::size_t h = 0; h < half_edges_.size(); ++h) {
    if (half_edges_[h].origin.value != kBoundary) moved[h] = HalfEdgeId{half_edges++};
  }
  const auto place = [&](HalfEdgeId h) { return h.value == kBoundary ? h : moved[h.index()]; };
  for (std::size_t h = 0; h < half_edges_.size(); ++h) {
    const HalfEdge old = half_edges_[h];
    if (old.origin.value == kBoundary) continue;
    half_edges_[moved[h].index()] = {*renamed[old.origin.index()], place(old.twin)};
  }
  for (std::size_t v = 0; v < renamed.size(); ++v) {
    if (renamed[v]) outgoing_[renamed[v]->index()] = place(outgoing_[v]);
  }
  outgoing_.resize(vertices);
  half_edges_.resize(half_edges);
  return renamed;
}

std::vector<std::array<std::uint32_t, 3>> SurfaceMesh::triangle_list() const {
  std::vector<std::array<std::uint32_t, 3>> list;
  list.reserve(triangle_count());
  for (std::size_t t = 0; t < triangle_count(); ++t) {
    if (is_removed(TriangleId{t})) continue;
    const auto [a, b, c] = corners(TriangleId{t});
    list.push_back({a.value, b.value, c.value});
  }
  return list;
}

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
/// at its origin; the lists stay short, so this is O(n).
/// @return whether none is left waiting.
bool glue_all(SurfaceMesh& mesh) {
  constexpr std::uint32_t none = 0xFFFFFFFFU;
  const std::size_t count = 3 * mesh.triangle_count();
  std::vector<std::uint32_t> first(mesh.vertex_count(), none), next(count, none);
  std::size_t waiting = 0;
  for (std::uint32_t h = 0; h < count; ++h) {
    const VertexId a = mesh.origin(HalfEdgeId{h}), b = mesh.target(HalfEdgeId{h});
    std::uint32_t* link = &first[b.index()];
    while (*link != none && mesh.target(HalfEdgeId{*link}) != a) link = &next[*link];
    if (*link == none) {
      next[h] = std::exchange(first[a.index()], h);
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

Components components(const SurfaceMesh& mesh) {
  // As the smallest stands for a set, components are numbered by their first triangle.
  UnionFind sets(mesh.triangle_count());
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.is_removed(TriangleId{t})) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
      if (mesh.is_boundary(h) || mesh.twin(h) > h) continue;
      sets.join(t, SurfaceMesh::triangle(mesh.twin(h)).value);
    }
  }
  Components result;
  result.of_triangle.resize(mesh.triangle_count());
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.is_removed(TriangleId{t})) continue;
    const std::uint32_t first = sets.root(t);
    result.of_triangle[t] = first == t ? result.count++ : result.of_triangle[first];
  }
  return result;
}

}  // namespace morskin::geometry
