#include "front/front.h"

#include <array>

namespace morskin::front {

using geometry::SurfaceMesh;
using Kind = FrontChange::Kind;

FrontEdgeId Front::open_edge(VertexId origin, HalfEdgeId half_edge) {
  FrontEdgeId e{edges_.size()};
  if (free_.empty()) {
    edges_.emplace_back();
  } else {
    e = free_.back();
    free_.pop_back();
  }
  FrontEdge& edge = edges_[e];
  edge.origin = origin;
  edge.half_edge = half_edge;
  edge.is_open = true;
  ++edge.generation;
  ++open_;
  const SurfacePoint& p = mesh_.at(origin);
  edge.position = p.position;
  edge.grid_keys = grid_.insert(e, p.position, p.length_scale);
  return e;
}

void Front::close_edge(FrontEdgeId e) {
  grid_.erase(e, edges_[e].grid_keys);
  edges_[e].is_open = false;
  free_.push_back(e);
  --open_;
}

void Front::open_fan(const SurfacePoint& centre, std::span<const SurfacePoint> rim) {
  SurfaceMesh& surface = mesh_.surface;
  const std::size_t n = rim.size();
  const VertexId p0 = mesh_.add_vertex(centre);
  std::vector<VertexId> p;
  for (const SurfacePoint& x : rim) p.push_back(mesh_.add_vertex(x));
  std::vector<geometry::TriangleId> fan;
  for (std::size_t i = 0; i < n; ++i) fan.push_back(surface.add_triangle(p0, p[i], p[(i + 1) % n]));
  std::vector<HalfEdgeId> outer;
  for (std::size_t i = 0; i < n; ++i) {
    surface.glue(SurfaceMesh::half_edge(fan[i], 2), SurfaceMesh::half_edge(fan[(i + 1) % n], 0));
    outer.push_back(SurfaceMesh::half_edge(fan[i], 1));
  }
  triangles_added_ += n;
  open_polygon(outer);
}

std::vector<FrontEdgeId> Front::open_polygon(std::span<const HalfEdgeId> half_edges) {
  std::vector<FrontEdgeId> polygon;
  for (const HalfEdgeId h : half_edges) polygon.push_back(open_edge(mesh_.surface.origin(h), h));
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    link(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  report({.kind = Kind::OpenedPolygon,
          .front = *this,
          .opened = polygon,
          .closed = {},
          .moved = {},
          .corners = polygon});
  return polygon;
}

/// The triangle on the bare side of e: its half-edge 0 glued to e's, 1 and 2 on the boundary.
geometry::TriangleId Front::add_triangle(FrontEdgeId e, VertexId apex) {
  const auto t = mesh_.surface.add_triangle(target(e), edges_[e].origin, apex);
  mesh_.surface.glue(SurfaceMesh::half_edge(t, 0), edges_[e].half_edge);
  ++triangles_added_;
  return t;
}

FrontEdgeId Front::attach(FrontEdgeId e, const SurfacePoint& x) {
  const VertexId apex = mesh_.add_vertex(x);
  const auto t = add_triangle(e, apex);
  const FrontEdgeId after = edges_[e].next;
  const FrontEdgeId added = open_edge(apex, SurfaceMesh::half_edge(t, 2));
  edges_[e].half_edge = SurfaceMesh::half_edge(t, 1);
  link(e, added);
  link(added, after);
  report({.kind = Kind::NewVertex,
          .front = *this,
          .opened = {&added, 1},
          .closed = {},
          .moved = {&e, 1},
          .corners = {&added, 1}});
  return added;
}

FrontEdgeId Front::attach(FrontEdgeId e, FrontEdgeId corner) {
  const VertexId v = edges_[corner].origin;
  const auto t = add_triangle(e, v);
  const FrontEdgeId after = edges_[e].next;
  const FrontEdgeId before_v = edges_[corner].previous;
  const FrontEdgeId added = open_edge(v, SurfaceMesh::half_edge(t, 2));
  edges_[e].half_edge = SurfaceMesh::half_edge(t, 1);
  link(e, corner);
  link(before_v, added);
  link(added, after);
  const std::array corners{added, corner};
  report({.kind = Kind::Touch,
          .front = *this,
          .opened = {&added, 1},
          .closed = {},
          .moved = {&e, 1},
          .corners = corners});
  return added;
}

void Front::close_corner(FrontEdgeId corner) {
  const FrontEdgeId before = edges_[corner].previous;
  const FrontEdgeId after = edges_[corner].next;
  const auto t = add_triangle(corner, edges_[before].origin);
  mesh_.surface.glue(SurfaceMesh::half_edge(t, 1), edges_[before].half_edge);
  edges_[before].half_edge = SurfaceMesh::half_edge(t, 2);
  link(before, after);
  close_edge(corner);
  if (edges_[after].next != before) {
    const std::array corners{before, after};
    report({.kind = Kind::ClosedCorner,
            .front = *this,
            .opened = {},
            .closed = {&corner, 1},
            .moved = {&before, 1},
            .corners = corners});
    return;
  }
  // The last two edges run to and fro between the same two vertices.
  mesh_.surface.glue(edges_[before].half_edge, edges_[after].half_edge);
  close_edge(before);
  close_edge(after);
  const std::array closed{corner, before, after};
  report({.kind = Kind::ClosedPolygon,
          .front = *this,
          .opened = {},
          .closed = closed,
          .moved = {},
          .corners = {}});
}

void Front::finish_edge(FrontEdgeId e, FrontEdgeId corner) {
  const FrontEdgeId after = edges_[e].next;
  if (corner == edges_[e].previous) {
    close_corner(e);
  } else if (edges_[corner].previous == after) {
    close_corner(after);
  } else {
    attach(e, corner);
  }
}

void Front::absorb(const Front& other, const IdOffsets& offsets) {
  for (FrontEdge edge : other.edges_) {
    edge.origin.value += offsets.vertices;
    edge.half_edge.value += offsets.half_edges;
    edge.next.value += offsets.edges;
    edge.previous.value += offsets.edges;
    const FrontEdgeId e{edges_.size()};
    if (edge.is_open) {
      edge.grid_keys = grid_.insert(e, edge.position, mesh_.at(edge.origin).length_scale);
    }
    edges_.push_back(edge);
  }
  for (const FrontEdgeId e : other.free_) free_.emplace_back(e.value + offsets.edges);
  open_ += other.open_;
  triangles_added_ += other.triangles_added_;
}

geometry::Parts Front::parts_behind() const {
  geometry::Parts parts(mesh_.surface.vertex_count(), 0);
  for (const FrontEdge& edge : edges_) {
    if (edge.is_open) parts[edge.origin] = geometry::no_part;
  }
  return parts;
}

void Front::compacted(const geometry::Renaming& renaming) {
  for (FrontEdge& edge : edges_) {
    if (!edge.is_open) continue;
    edge.origin = *renaming.vertices[edge.origin];
    edge.half_edge = renaming(edge.half_edge);
  }
}

}  // namespace morskin::front
