#include "front/front.h"

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
  ++edge.generation;
  ++open_;
  const SurfacePoint& p = mesh_.at(origin);
  edge.position = p.position;
  grid_.insert(e, p.position, p.length_scale);
  return e;
}

void Front::close_edge(FrontEdgeId e) {
  const SurfacePoint& p = mesh_.at(edges_[e.index()].origin);
  grid_.erase(e, p.position, p.length_scale);
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
  for (FrontEdge edge : other.edges_) {
    edge.origin.value += vertices;
    edge.half_edge.value += half_edges;
    edge.next.value += edges;
    edge.previous.value += edges;
    const FrontEdgeId e{edges_.size()};
    edges_.push_back(edge);
    if (edge.is_open) grid_.insert(e, edge.position, mesh_.at(edge.origin).length_scale);
  }
  for (const FrontEdgeId e : other.free_) free_.emplace_back(e.value + edges);
  open_ += other.open_;
  return edges;
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

/// Glues the last two edges of a polygon, which run to and fro between the same two vertices.
void Front::zip(FrontEdgeId e) {
  const FrontEdgeId f = edges_[e.index()].next;
  mesh_.surface.glue(edges_[e.index()].half_edge, edges_[f.index()].half_edge);
  close_edge(e);
  close_edge(f);
}

}  // namespace morskin::front
