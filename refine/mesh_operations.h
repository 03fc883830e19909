#pragma once

/// The operations of section 4.3 for whatever keeps a mesh: refinement, coarsening, the growing
/// mesh. Each asks for vertices by a callback at(v), a SurfacePoint, so these may also move.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "refine/names.h"

namespace morskin::refine {

/// Whether the triangle's normal agrees with the surface's at all corners.
template <class At>
bool faces_outward(const At& at, VertexId a, VertexId b, VertexId c) {
  const SurfacePoint &p = at(a), &q = at(b), &r = at(c);
  const Vector n = (q.position - p.position).cross(r.position - p.position);
  return is_upright(n, p, q, r);
}

/// Whether an edge's flip leaves two triangles that face outward, and no edge twice.
template <class At>
bool can_flip(const SurfaceMesh& mesh, const At& at, HalfEdgeId h) {
  const HalfEdgeId g = mesh.twin(h);
  const VertexId a = mesh.origin(h), b = mesh.origin(g), c = mesh.apex(h), d = mesh.apex(g);
  return c != d && faces_outward(at, a, d, c) && faces_outward(at, b, c, d) && !mesh.has_edge(c, d);
}

/// The half-edge from one vertex to another; none() where no edge joins them.
inline HalfEdgeId half_edge_between(const SurfaceMesh& mesh, VertexId from, VertexId to) {
  HalfEdgeId found = HalfEdgeId::none();
  mesh.for_each_outgoing(from, [&](HalfEdgeId h) {
    if (mesh.target(h) == to) found = h;
  });
  return found;
}

/// Removes one end of a short edge, the other stays in place. The bound in [L] is that of the end
/// with the larger length scale, so that one is tried first.
/// @param remove  VertexId -> whether it could be removed
template <class At, class Remove>
bool contract_edge(const SurfaceMesh& mesh, const At& at, HalfEdgeId h, const Remove& remove) {
  const VertexId a = mesh.origin(h), b = mesh.target(h);
  const bool a_first = at(a).length_scale >= at(b).length_scale;
  return remove(a_first ? a : b) || remove(a_first ? b : a);
}

/// Whether x, a point of the surface over a triangle, lies on the sheet that the triangle follows.
/// The two balls of radius rho that touch the surface at x do not meet it, so along x's normal
/// other sheets are 2 rho away, and a triangle in the tube is nearer to its own sheet than rho.
template <class At>
bool is_near(const At& at, const std::array<VertexId, 3>& triangle, const SurfacePoint& x) {
  const auto& [a, b, c] = triangle;
  const Vector to_a = at(a).position - x.position;
  const Vector n = (at(b).position - at(a).position).cross(at(c).position - at(a).position);
  return std::abs(n.dot(to_a)) < x.length_scale * std::abs(n.dot(x.normal));
}

/// Where a triangle is broken: at the centre of its surface ball, in the triangle that this lies
/// over.
struct Insertion {
  SurfacePoint point;
  TriangleId under;
};
/// @param may_cross  whether the search for that triangle may cross an edge
template <class At, class MayCross>
std::optional<Insertion> find_insertion(const surface::Surface& surface, const SurfaceMesh& mesh,
                                        const At& at, TriangleId t, const MayCross& may_cross) {
  const auto [a, b, c] = mesh.corners(t);
  const SurfaceBall ball = exact_surface_ball(surface, at(a), at(b).position, at(c).position);
  const auto x = surface.project(ball.centre, at(a).cell);
  if (!x) return std::nullopt;
  const auto position = [&](VertexId v) -> const Point& { return at(v).position; };
  const auto under = triangle_under(mesh, position, t, *x, may_cross);
  if (!under || !is_near(at, mesh.corners(*under), *x)) return std::nullopt;
  return Insertion{*x, *under};
}

/// Removes a vertex. plan() cuts the polygon of its neighbours into triangles, the smallest ear
/// first because Delaunay triangles have small circles; carry_out() flips edges away in that order.
/// A refused plan changes nothing, and triangles on the way need not be good.
class VertexRemoval {
 public:
  /// Size of an ear that must not be cut off.
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// Removes v if triangles that face outward can replace it, those with the smallest circles.
  /// @return what is free now; nothing where v has to stay
  template <class At, class Flipped>
  std::optional<SurfaceMesh::FreeSlots> remove(SurfaceMesh& mesh, const At& at, VertexId v,
                                               const Flipped& flipped) {
    const auto size = [&](VertexId a, VertexId b, VertexId c) {
      return faces_outward(at, a, b, c)
                 ? circumcircle(at(a).position, at(b).position, at(c).position).radius
                 : never;
    };
    const auto is_any_allowed = [](VertexId, VertexId, VertexId) { return true; };
    if (!plan(mesh, v, size, is_any_allowed)) return std::nullopt;
    return carry_out(mesh, flipped);
  }

  /// Cuts the polygon.
  /// @param size        of the triangle (a, b, c) that would cut off b, or never
  /// @param is_allowed  asked of every triangle of a plan that is complete, the last ones first,
  ///                    for these are the largest; one refused refuses the plan
  /// @return whether v can be taken out
  /// @pre v has no boundary, nor have its neighbours
  template <class Size, class IsAllowed>
  bool plan(const SurfaceMesh& mesh, VertexId v, const Size& size, const IsAllowed& is_allowed);

  /// Removes the vertex of the last plan.
  /// @param flipped  called with each half-edge flipped on the way
  /// @return what is free now
  template <class Flipped>
  SurfaceMesh::FreeSlots carry_out(SurfaceMesh& mesh, const Flipped& flipped);
  /// The last of the triangles that replaced it.
  TriangleId triangle_left() const { return left_; }

 private:
  VertexId vertex_;
  TriangleId left_;
  std::vector<VertexId> polygon_;  ///< the neighbours left, counter-clockwise
  std::vector<double> ears_;       ///< by corner, the size of the triangle that would cut it off
  std::vector<std::array<VertexId, 3>> cut_;  ///< triangles, all but the last with a tip cut off
};

template <class Size, class IsAllowed>
bool VertexRemoval::plan(const SurfaceMesh& mesh, VertexId v, const Size& size,
                         const IsAllowed& is_allowed) {
  vertex_ = v;
  cut_.clear();
  polygon_.clear();
  mesh.for_each_outgoing(v, [&](HalfEdgeId h) { polygon_.push_back(mesh.target(h)); });
  ears_.resize(polygon_.size());
  const auto before = [&](std::size_t i) { return i == 0 ? polygon_.size() - 1 : i - 1; };
  const auto after = [&](std::size_t i) { return i + 1 == polygon_.size() ? 0 : i + 1; };
  const auto measure = [&](std::size_t i) {
    ears_[i] = size(polygon_[before(i)], polygon_[i], polygon_[after(i)]);
  };
  for (std::size_t i = 0; i < polygon_.size(); ++i) measure(i);
  while (polygon_.size() > 3) {
    const auto best = static_cast<std::size_t>(std::ranges::min_element(ears_) - ears_.begin());
    if (ears_[best] == never) return false;
    const VertexId a = polygon_[before(best)], tip = polygon_[best], b = polygon_[after(best)];
    if (mesh.has_edge(a, b) || !mesh.has_degree_above(tip, 3)) {
      ears_[best] = never;
      continue;
    }
    cut_.push_back({a, tip, b});
    polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(best));
    ears_.erase(ears_.begin() + static_cast<std::ptrdiff_t>(best));
    const std::size_t next = best == polygon_.size() ? 0 : best;
    measure(before(next));
    measure(next);
  }
  const auto [a, b, c] = std::array{polygon_[0], polygon_[1], polygon_[2]};
  cut_.push_back({a, b, c});
  return a != b && b != c && c != a &&
         std::ranges::all_of(polygon_, [&](VertexId x) { return mesh.has_degree_above(x, 3); }) &&
         size(a, b, c) != never && std::all_of(cut_.rbegin(), cut_.rend(), [&](const auto& t) {
           return is_allowed(t[0], t[1], t[2]);
         });
}

template <class Flipped>
SurfaceMesh::FreeSlots VertexRemoval::carry_out(SurfaceMesh& mesh, const Flipped& flipped) {
  for (const auto& ear : std::span(cut_).first(cut_.size() - 1)) {
    const HalfEdgeId to_tip = half_edge_between(mesh, vertex_, ear[1]);
    mesh.flip(to_tip);
    flipped(to_tip);
  }
  left_ = SurfaceMesh::triangle(*mesh.outgoing(vertex_));  // keeps its id
  return mesh.unsplit(vertex_);
}

}  // namespace morskin::refine
