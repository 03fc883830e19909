#include "bench/baselines/moving_mesh.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace morskin::baselines {

using certify::circumcircle;

VertexId MovingMesh::add_vertex(SurfacePoint p) {
  const VertexId v = surface_.add_vertex();
  moving_[v] = {p, now_, Trajectory(skin_, p.position, p.cell, now_)};
  enter(v, p.cell);
  return v;
}

void MovingMesh::move(VertexId v, Moving& moving) {
  if (moving.path.begins() > now_) return;
  if (moving.path.leaves() <= now_) {
    moving.path = moving.path.followed_to(skin_, now_);
    enter(v, moving.path.cell());
  }
  moving.point = moving.path.at(skin_, now_);
  moving.clock = now_;
}

std::uint32_t MovingMesh::watch(const std::vector<CellId>& cells) {
  const auto w = static_cast<std::uint32_t>(visitors_.size());
  visitors_.emplace_back();
  for (const CellId cell : cells) watch_[cell] = w;
  return w;
}

void MovingMesh::forget(std::uint32_t watch, const std::vector<CellId>& cells) {
  visitors_[watch] = {};
  for (const CellId cell : cells) watch_[cell] = no_index;
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
  std::ranges::sort(corners);
  const auto twice = std::ranges::unique(corners);
  corners.erase(twice.begin(), twice.end());
  surface_.remove(triangles);
  for (const VertexId v : corners) {
    if (!surface_.outgoing(v)) ++dead_;
  }
}

void MovingMesh::compact() {
  const geometry::Renaming renaming = surface_.compact();
  for (std::vector<VertexId>& visitors : visitors_) renaming.apply_to(visitors);
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

/// Whether the triangle's normal agrees with the skin's at all its corners.
bool MovingMesh::faces_outward(VertexId a, VertexId b, VertexId c) {
  const Vector n = (position(b) - position(a)).cross(position(c) - position(a));
  const double least = 0.3 * n.norm();
  return n.dot(at(a).normal) > least && n.dot(at(b).normal) > least && n.dot(at(c).normal) > least;
}

bool MovingMesh::can_flip(HalfEdgeId h) {
  const HalfEdgeId g = surface_.twin(h);
  const VertexId a = surface_.origin(h), b = surface_.origin(g);
  const VertexId c = surface_.apex(h), d = surface_.apex(g);
  return c != d && faces_outward(a, d, c) && faces_outward(b, c, d) && !surface_.has_edge(c, d);
}

void MovingMesh::flip(HalfEdgeId h) {
  const HalfEdgeId g = surface_.twin(h);
  surface_.flip(h);
  ++counts.flip;
  add_changed(SurfaceMesh::triangle(h));
  add_changed(SurfaceMesh::triangle(g));
}

bool MovingMesh::flip_if_better(HalfEdgeId h) {
  const HalfEdgeId g = surface_.twin(h);
  const VertexId a = surface_.origin(h), b = surface_.origin(g);
  const VertexId c = surface_.apex(h), d = surface_.apex(g);
  const certify::SurfaceBall left = exact_ball(a, b, c), right = exact_ball(b, a, d);
  const double now = std::max(left.intrusion(position(d)), right.intrusion(position(c)));
  // A share that rounding and motion do not turn at once.
  constexpr double least_gain = 1e-3;
  const double gain = least_gain * std::min(left.squared_radius, right.squared_radius);
  if (now <= gain || !can_flip(h)) return false;
  const double then = std::max(exact_ball(a, d, c).intrusion(position(b)),
                               exact_ball(b, c, d).intrusion(position(a)));
  if (then >= now - gain) return false;
  flip(h);
  return true;
}

bool MovingMesh::contract(HalfEdgeId h) {
  const VertexId a = surface_.origin(h), b = surface_.target(h);
  // The end with the larger length scale is the one that finds the edge too short.
  const bool a_first = at(a).length_scale >= at(b).length_scale;
  const bool is_removed = remove(a_first ? a : b) || remove(a_first ? b : a);
  counts.contract += is_removed;
  return is_removed;
}

/// Takes a vertex out. The polygon of its neighbours is cut into ears first, the smallest first,
/// and only if that succeeds the edges are flipped away in this order: what is refused changes
/// nothing.
bool MovingMesh::remove(VertexId v) {
  link_.clear();
  surface_.for_each_outgoing(v, [&](HalfEdgeId h) { link_.push_back(surface_.target(h)); });
  cuts_.clear();
  while (link_.size() > 3) {
    std::size_t best = link_.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < link_.size(); ++i) {
      const VertexId d = link_[(i + link_.size() - 1) % link_.size()], x = link_[i];
      const VertexId c = link_[(i + 1) % link_.size()];
      const double size = circumcircle(position(d), position(x), position(c)).radius;
      if (size >= least || surface_.degree(x) <= 3 || !faces_outward(d, x, c) ||
          surface_.has_edge(c, d)) {
        continue;
      }
      least = size;
      best = i;
    }
    if (best == link_.size()) return false;
    cuts_.push_back(link_[best]);
    link_.erase(link_.begin() + static_cast<std::ptrdiff_t>(best));
  }
  if (!faces_outward(link_[0], link_[1], link_[2])) return false;
  for (const VertexId corner : link_) {
    if (surface_.degree(corner) <= 3) return false;
  }
  for (const VertexId x : cuts_) {
    surface_.for_each_outgoing(v, [&](HalfEdgeId h) {
      if (surface_.target(h) == x) to_cut_ = h;
    });
    flip(to_cut_);
  }
  const HalfEdgeId first = *surface_.outgoing(v);
  surface_.unsplit(v);
  ++dead_;
  add_changed(SurfaceMesh::triangle(first));
  return true;
}

bool MovingMesh::insert(TriangleId t, double least_L) {
  const auto [a, b, c] = surface_.corners(t);
  const auto x = level_.project(exact_ball(a, b, c).centre, at(a).cell);
  if (!x) return false;
  const auto place = [&](VertexId v) -> const Point& { return position(v); };
  const auto found =
      certify::triangle_under(surface_, place, t, *x, [](HalfEdgeId) { return true; });
  if (!found) return false;
  const TriangleId under = *found;
  for (const VertexId v : surface_.corners(under)) {
    if (sizing_.edge_ratio(at(v), *x) < least_L) return false;
  }
  // Beside an edge the point would make a triangle as good as flat: turn that edge at once.
  constexpr double beside = 0.1;  // of the edge's length
  std::optional<std::uint32_t> nearest;
  double least = beside;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const HalfEdgeId h = SurfaceMesh::half_edge(under, k);
    const Point& p = position(surface_.origin(h));
    const Vector edge = position(surface_.target(h)) - p;
    const double height = edge.cross(x->position - p).dot(x->normal) / edge.squaredNorm();
    if (height >= least) continue;
    least = height;
    nearest = k;
  }
  const std::size_t before = surface_.triangle_count();
  const VertexId v = add_vertex(*x);
  surface_.split(under, v);
  const std::array<TriangleId, 3> around{under, TriangleId{before}, TriangleId{before + 1}};
  for (const TriangleId one : around) add_changed(one);
  add_changed(t);  // x may lie under another
  // The k-th of the three has the k-th edge of the triangle that was split as its first.
  if (nearest) {
    const HalfEdgeId h = SurfaceMesh::half_edge(around[*nearest], 0);
    if (can_flip(h)) flip(h);
  }
  ++counts.insert;
  return true;
}

}  // namespace morskin::baselines
