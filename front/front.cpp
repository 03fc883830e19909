#include "front/front.h"

#include <algorithm>
#include <cassert>

namespace morskin::front {

using geometry::SurfaceMesh;

FrontEdgeId Front::open_edge(VertexId origin, HalfEdgeId half_edge) {
  FrontEdgeId e{edges_.size()};
  if (free_.empty()) {
    edges_.emplace_back();
  } else {
    e = free_.back();
    free_.pop_back();
  }
  FrontEdge& edge = edges_[e.index()];
  edge.origin = origin;
  edge.half_edge = half_edge;
  edge.is_open = true;
  edge.loop = 0;
  ++edge.generation;
  ++open_;
  const SurfacePoint& p = mesh_.at(origin);
  edge.position = p.position;
  edge.filed = grid_.insert(e, p.position, p.length_scale);
  return e;
}

void Front::close_edge(FrontEdgeId e) {
  grid_.erase(e, edges_[e.index()].filed);
  edges_[e.index()].is_open = false;
  free_.push_back(e);
  --open_;
}

std::vector<FrontEdgeId> Front::open_polygon(std::span<const HalfEdgeId> half_edges) {
  std::vector<FrontEdgeId> polygon;
  for (const HalfEdgeId h : half_edges) polygon.push_back(open_edge(mesh_.surface.origin(h), h));
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    link(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return polygon;
}

std::uint32_t Front::append(const Front& other, std::uint32_t vertices, std::uint32_t half_edges) {
  const auto edges = static_cast<std::uint32_t>(edges_.size());
  const auto loops = static_cast<std::uint32_t>(loops_.size() - 1);
  loops_.insert(loops_.end(), other.loops_.begin() + 1, other.loops_.end());
  for (FrontEdge edge : other.edges_) {
    edge.origin.value += vertices;
    edge.half_edge.value += half_edges;
    edge.loop += edge.loop == 0 ? 0 : loops;
    edge.next.value += edges;
    edge.previous.value += edges;
    const FrontEdgeId e{edges_.size()};
    if (edge.is_open) {
      edge.filed = grid_.insert(e, edge.position, mesh_.at(edge.origin).length_scale);
    }
    edges_.push_back(edge);
  }
  for (const FrontEdgeId e : other.free_) free_.emplace_back(e.value + edges);
  open_ += other.open_;
  return edges;
}

std::vector<char> Front::marked_vertices() const {
  std::vector<char> is_on_front(mesh_.surface.vertex_count(), 0);
  for (const FrontEdge& edge : edges_) {
    if (edge.is_open) is_on_front[edge.origin.index()] = 1;
  }
  return is_on_front;
}

void Front::rename(const SurfaceMesh::Renaming& renaming) {
  for (FrontEdge& edge : edges_) {
    if (!edge.is_open) {
      edge.origin =
          VertexId{0U};  // some vertex, for whoever asks ahead for that of a stale departure
      continue;
    }
    edge.origin = *renaming.vertices[edge.origin.index()];
    edge.half_edge = renaming(edge.half_edge);
  }
}

/// The triangle on the bare side of e: its half-edge 0 glued to e's, 1 and 2 on the boundary.
geometry::TriangleId Front::add_triangle(FrontEdgeId e, VertexId apex) {
  const auto t = mesh_.surface.add_triangle(target(e), edges_[e.index()].origin, apex);
  mesh_.surface.glue(SurfaceMesh::half_edge(t, 0), edges_[e.index()].half_edge);
  return t;
}

FrontEdgeId Front::attach(FrontEdgeId e, const SurfacePoint& x) {
  const VertexId apex = mesh_.add_vertex(x);
  const auto t = add_triangle(e, apex);
  const FrontEdgeId after = edges_[e.index()].next;
  const FrontEdgeId added = open_edge(apex, SurfaceMesh::half_edge(t, 2));
  edges_[added.index()].loop = edges_[e.index()].loop;
  edges_[e.index()].half_edge = SurfaceMesh::half_edge(t, 1);
  link(e, added);
  link(added, after);
  return added;
}

FrontEdgeId Front::attach(FrontEdgeId e, FrontEdgeId corner) {
  const VertexId v = edges_[corner.index()].origin;
  const auto t = add_triangle(e, v);
  const FrontEdgeId after = edges_[e.index()].next;
  const FrontEdgeId before_v = edges_[corner.index()].previous;
  const FrontEdgeId added = open_edge(v, SurfaceMesh::half_edge(t, 2));
  edges_[added.index()].loop = edges_[corner.index()].loop;
  edges_[e.index()].half_edge = SurfaceMesh::half_edge(t, 1);
  link(e, corner);
  link(before_v, added);
  link(added, after);
  return added;
}

void Front::close_corner(FrontEdgeId corner) {
  const FrontEdgeId before = edges_[corner.index()].previous;
  const FrontEdgeId after = edges_[corner.index()].next;
  const auto t = add_triangle(corner, edges_[before.index()].origin);
  mesh_.surface.glue(SurfaceMesh::half_edge(t, 1), edges_[before.index()].half_edge);
  edges_[before.index()].half_edge = SurfaceMesh::half_edge(t, 2);
  link(before, after);
  close_edge(corner);
  if (edges_[after.index()].next == before) zip(before);
}

void Front::watch_touch(FrontEdgeId e, FrontEdgeId added, bool is_predicted) {
  for (const FrontEdgeId side : {e, edges_[e.index()].next, added}) {
    loops_[edges_[side.index()].loop].met_another = true;
  }
  // From both edges on at once: the polygon was split if one comes round without meeting the other.
  FrontEdgeId a = e, b = added;
  do {
    a = edges_[a.index()].next;
    b = edges_[b.index()].next;
    if (a == added || b == e) return;
  } while (a != e && b != added);
  const FrontEdgeId first = a == e ? e : added;
  const auto loop = static_cast<std::uint32_t>(loops_.size());
  loops_.push_back({.is_predicted = is_predicted});
  FrontEdgeId edge = first;
  do {
    edges_[edge.index()].loop = loop;
    edge = edges_[edge.index()].next;
  } while (edge != first);
}

std::size_t Front::vain_loops(bool is_predicted) const {
  return static_cast<std::size_t>(std::count_if(
      loops_.begin() + 1, loops_.end(),
      [&](const Loop& loop) { return loop.is_predicted == is_predicted && loop.is_vain(); }));
}

/// Glues the last two edges of a polygon, which run to and fro between the same two vertices.
void Front::zip(FrontEdgeId e) {
  const FrontEdgeId f = edges_[e.index()].next;
  mesh_.surface.glue(edges_[e.index()].half_edge, edges_[f.index()].half_edge);
  loops_[edges_[e.index()].loop].is_closed = true;
  close_edge(e);
  close_edge(f);
}

}  // namespace morskin::front
