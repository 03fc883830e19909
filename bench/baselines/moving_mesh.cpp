#include "bench/baselines/moving_mesh.h"

#include <algorithm>
#include <utility>

#include "geometry/sort_unique.h"

namespace morskin::baselines {

VertexId MovingMesh::add_vertex(SurfacePoint p) {
  const VertexId v = surface_.add_vertex();
  moving_[v] = {p, now_, Trajectory(skin_, p.position, p.cell, now_)};
  return v;
}

void MovingMesh::move(Moving& moving) {
  if (moving.path.begins() > now_) return;
  if (moving.path.leaves() <= now_) moving.path = moving.path.followed_to(skin_, now_);
  moving.point = moving.path.at(skin_, now_);
  moving.clock = now_;
}

std::optional<TriangleId> MovingMesh::take_changed() {
  if (changed_.empty()) return std::nullopt;
  const TriangleId t = changed_.back();
  changed_.pop_back();
  is_changed_[t] = 0;
  return t;
}

void MovingMesh::add_changed(TriangleId t) {
  if (std::exchange(is_changed_[t], 1) == 0) changed_.push_back(t);
}

void MovingMesh::remove(const std::vector<TriangleId>& triangles) {
  std::vector<VertexId> corners;
  for (const TriangleId t : triangles) {
    for (const VertexId v : surface_.corners(t)) corners.push_back(v);
  }
  geometry::sort_unique(corners);
  surface_.remove(triangles);
  for (const VertexId v : corners) {
    if (!surface_.outgoing(v)) ++dead_;
  }
}

void MovingMesh::compact() {
  surface_.compact();
  dead_ = 0;
}

surface::Mesh MovingMesh::snapshot() {
  surface::Mesh copy(surface_);
  for (std::size_t v = 0; v < surface_.vertex_count(); ++v) {
    if (surface_.outgoing(VertexId{v})) copy.points[VertexId{v}] = at(VertexId{v});
  }
  copy.surface.compact();
  return copy;
}

void MovingMesh::note_flip(HalfEdgeId h) {
  ++counts.flip;
  add_changed(SurfaceMesh::triangle(h));
  add_changed(SurfaceMesh::triangle(surface_.twin(h)));
}

bool MovingMesh::flip_if_better(HalfEdgeId h) {
  const HalfEdgeId g = surface_.twin(h);
  const VertexId a = surface_.origin(h), b = surface_.origin(g);
  const VertexId c = surface_.apex(h), d = surface_.apex(g);
  const certify::SurfaceBall left = exact_ball(a, b, c), right = exact_ball(b, a, d);
  const double now = std::max(left.intrusion(position(d)), right.intrusion(position(c)));
  // A share that rounding and motion do not turn at once.
  constexpr double min_gain = 1e-3;
  const double gain = min_gain * std::min(left.squared_radius, right.squared_radius);
  if (now <= gain || !refine::can_flip(surface_, points(), h)) return false;
  const double then = std::max(exact_ball(a, d, c).intrusion(position(b)),
                               exact_ball(b, c, d).intrusion(position(a)));
  if (then >= now - gain) return false;
  surface_.flip(h);
  note_flip(h);
  return true;
}

bool MovingMesh::contract(HalfEdgeId h) {
  const bool is_removed =
      refine::contract_edge(surface_, points(), h, [&](VertexId v) { return remove(v); });
  counts.contract += is_removed;
  return is_removed;
}

bool MovingMesh::remove(VertexId v) {
  if (!removal_.remove(surface_, points(), v, [&](HalfEdgeId h) { note_flip(h); })) return false;
  ++dead_;
  add_changed(removal_.triangle_left());
  return true;
}

bool MovingMesh::insert(TriangleId t, double min_L) {
  const auto where =
      refine::find_insertion(level_, surface_, points(), t, [](HalfEdgeId) { return true; });
  if (!where) return false;
  const SurfacePoint& x = where->point;
  const TriangleId under = where->under;
  // A thin triangle's ball may have its centre on another part of the skin, far above the triangle
  // that the walk ends at.
  constexpr double over = 2.5;  // circumradii; no point of a triangle is more than 2 from a corner
  const auto [a, b, c] = surface_.corners(under);
  const double reach = over * certify::circumcircle(position(a), position(b), position(c)).radius;
  for (const VertexId v : {a, b, c}) {
    if (sizing_.edge_ratio(at(v), x) < min_L) return false;
    if ((position(v) - x.position).norm() > reach) return false;
  }
  // Beside an edge the point would make a triangle as good as flat: turn that edge at once.
  constexpr double beside = 0.1;  // of the edge's length
  std::optional<std::uint32_t> nearest;
  double least = beside;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const HalfEdgeId h = SurfaceMesh::half_edge(under, k);
    const Point& p = position(surface_.origin(h));
    const Vector edge = position(surface_.target(h)) - p;
    const double height = edge.cross(x.position - p).dot(x.normal) / edge.squaredNorm();
    if (height >= least) continue;
    least = height;
    nearest = k;
  }
  const std::size_t before = surface_.triangle_count();
  const VertexId v = add_vertex(x);
  surface_.split(under, v);
  const std::array<TriangleId, 3> around{under, TriangleId{before}, TriangleId{before + 1}};
  for (const TriangleId one : around) add_changed(one);
  add_changed(t);  // x may lie under another
  // The k-th of the three has the k-th edge of the triangle that was split as its first.
  if (nearest) {
    const HalfEdgeId h = SurfaceMesh::half_edge(around[*nearest], 0);
    if (refine::can_flip(surface_, points(), h)) {
      surface_.flip(h);
      note_flip(h);
    }
  }
  ++counts.insert;
  return true;
}

}  // namespace morskin::baselines
