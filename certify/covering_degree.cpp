#include "certify/covering_degree.h"

#include <algorithm>
#include <atomic>
#include <cfloat>
#include <cmath>

#include "certify/candidate_grid.h"
#include "certify/distance_bounds.h"
#include "geometry/kd_tree.h"
#include "geometry/orthogonal.h"
#include "geometry/parallel.h"

namespace morskin::certify {

namespace {

/// Margins far above the rounding of the few operations that they follow.
constexpr double up = 1 + 1e-6, down = 1 - 1e-6;

/// No candidate lies farther from the skin, over its length scale.
constexpr double max_own_path = 0x1p-4;

/// For what each thread may find of its own, in any order.
constexpr auto relaxed = std::memory_order_relaxed;

}  // namespace

void FlowBounds::add(std::uint32_t triangle, double circumradius, double max_path, double rho,
                     double max_error) {
  // A point of the triangle lies within R of a corner.
  const double ratio = up * (circumradius + max_path) / rho;
  if (ratio > max_ratio || !(max_error < max_doubt * rho)) {
    const double distance = std::min<double>(up * (2 * circumradius + max_path), FLT_MAX);
    far_.push_back({triangle, static_cast<float>(distance)});
  } else {
    ratio_ = std::max(ratio_, ratio);
  }
}

void FlowBounds::add(FlowBounds others) {
  ratio_ = std::max(ratio_, others.ratio_);
  far_.insert(far_.end(), others.far_.begin(), others.far_.end());
}

bool CoveringDegree::is_candidate(VertexId v) const {
  const double rho = min_length_scale(v);
  return on_.vertices[v.index()].error < FlowBounds::max_doubt * rho &&
         path_to_skin(v) < max_own_path * rho && own_triangles_do_not_return(v) && turns_once(v);
}

/// Whether the flow carries no other point of the triangles at v to where it carries v.
///
/// The two would lie on one path, along which G changes by no more than between v and a point of
/// the triangle, so it would be no longer than `path`. But along so short a path from v N keeps a
/// part along the triangle's normal, so that it never comes back to the triangle's plane.
bool CoveringDegree::own_triangles_do_not_return(VertexId v) const {
  const SurfacePoint p = on_.point(v.value);
  const LocatedVertex& known = on_.vertices[v.index()];
  bool holds = true;
  connectivity_.for_each_outgoing(v, [&](HalfEdgeId h) {
    const std::array triangle{v.value, connectivity_.target(h).value, connectivity_.apex(h).value};
    const TriangleBounds shape = on_.shape(triangle);
    const double g = shape.circumradius * shape.circumradius +
                     on_.corner_bounds(triangle).max_value() + known.max_value();
    const double path = max_flow_path(min_length_scale(v), up * g);
    const double upright =
        p.length_scale * (p.normal.dot(shape.normal) - shape.normal_error) - known.error;
    holds = holds && up * path < down * upright;
  });
  return holds;
}

/// Whether the triangles at v go round it exactly once, seen along its normal. All turn forward, by
/// (c1), so one turn has one edge where the side of a plane through the normal changes from back to
/// front. An edge too near to the plane leaves that open; then another plane is tried.
/// @pre own_triangles_do_not_return(v), so that other directions near the normal would do as well.
bool CoveringDegree::turns_once(VertexId v) const {
  const SurfacePoint p = on_.point(v.value);
  const geometry::TangentFrame frame(p.normal);
  constexpr int planes = 4;
  for (int plane = 0; plane < planes; ++plane) {
    const Vector across = frame.direction(plane);
    int changes = 0;
    bool is_sure = true;
    std::optional<bool> first, last;
    connectivity_.for_each_outgoing(v, [&](HalfEdgeId h) {
      const Vector edge = on_.position(connectivity_.target(h).value) - p.position;
      const double side = across.dot(edge);
      constexpr double doubt = 0x1p-46;  // over the rounding of `side` and of the directions
      is_sure = is_sure && std::abs(side) > doubt * edge.norm();
      const bool is_front = side > 0;
      changes += last && !*last && is_front;
      if (!first) first = is_front;
      last = is_front;
    });
    changes += !*last && *first;
    if (is_sure) return changes == 1;
  }
  return false;
}

/// Whether the flow may carry a point p of a triangle to where it carries the vertex v, not one of
/// its corners.
///
/// Then one path joins p and v, along which G changes by |G(p) - G(v)| <= R^2 + |G| at the corners
/// and at v. On a path of length s from v N changes by at most s, so the path's direction differs
/// from v's normal by a sine of at most s / rho: it ends within s^2 / (2 rho) of the line along
/// that normal.
bool CoveringDegree::may_cover(const geometry::TriangleCorners& triangle, VertexId v) const {
  const SurfacePoint at = on_.point(v.value);
  const LocatedVertex& known = on_.vertices[v.index()];
  const TriangleBounds shape = on_.shape(triangle);
  const CornerBounds corners = on_.corner_bounds(triangle);
  const double g =
      shape.circumradius * shape.circumradius + corners.max_value() + known.max_value();
  Offsets offsets;
  for (std::size_t k = 0; k < 3; ++k) offsets[k] = on_.position(triangle[k]) - at.position;
  const double distance = distance_below(offsets);
  double path = max_flow_path(min_length_scale(v), up * g);
  if (distance > up * path) return false;
  const LocatedMesh::CornerPoints points = on_.corners(triangle);
  const TubeProof proof = prove_tube(on_.surface, points, shape, corners);
  path = std::min(path, proof.max_path + path_to_skin(v));
  if (distance > up * path) return false;
  const double aside = path * (path / 2 + known.error) / at.length_scale;
  return !(distance_from_line_below(offsets, at.normal) > up * aside);
}

/// A few of each component, spread over it: where the surface is thin against its length scale,
/// triangles of another sheet may cover some of them.
CoveringDegree::Candidates CoveringDegree::candidates() const {
  constexpr std::size_t max_candidates = 16;
  const std::size_t count = 1 + std::ranges::max(components_);
  std::vector<std::uint32_t> size(count, 0), seen(count, 0), number(count, geometry::no_index);
  for (const std::uint32_t c : components_) ++size[c];
  std::uint32_t numbered = 0;
  for (auto t = on_.mesh.triangles.begin(); numbered < count; ++t) {
    std::uint32_t& n = number[components_[(*t)[0]]];
    if (n == geometry::no_index) n = numbered++;
  }
  Candidates result(count);
  for (std::size_t v = 0; v < components_.size(); ++v) {
    const std::uint32_t c = components_[v];
    if (seen[c]++ % (size[c] / max_candidates + 1) != 0) continue;
    if (is_candidate(VertexId{v})) result[number[c]].push_back(VertexId{v});
  }
  return result;
}

std::vector<char> CoveringDegree::free_candidates(const Candidates& candidates,
                                                  unsigned threads) const {
  std::vector<VertexId> all;
  for (const auto& list : candidates) all.insert(all.end(), list.begin(), list.end());
  std::vector<char> is_free(on_.mesh.positions.size(), 0);
  for (const VertexId v : all) is_free[v.index()] = 1;
  const auto test = [&](const geometry::TriangleCorners& t, VertexId v) {
    const bool is_own = t[0] == v.value || t[1] == v.value || t[2] == v.value;
    const std::atomic_ref free(is_free[v.index()]);
    if (!is_own && free.load(relaxed) && may_cover(t, v)) free.store(0, relaxed);
  };
  test_far_triangles(all, threads, test);
  test_near_triangles(all, threads, test);
  return is_free;
}

/// Tests each far triangle against the candidates within its bound.
template <class Test>
void CoveringDegree::test_far_triangles(const std::vector<VertexId>& candidates, unsigned threads,
                                        Test test) const {
  if (bounds_.far().empty()) return;
  std::vector<Point> positions;
  positions.reserve(candidates.size());
  double own_path = 0;
  for (const VertexId v : candidates) {
    positions.push_back(on_.position(v.value));
    own_path = std::max(own_path, path_to_skin(v));
  }
  const geometry::KdTree<VertexId> tree(positions);
  constexpr double margin = 1.01;  // far above the rounding to single precision
  const auto far = bounds_.far();
  geometry::for_each_block(threads, far.size(), [&](auto begin, auto end, auto) {
    for (const auto& [t, from_first_corner] : far.subspan(begin, end - begin)) {
      const auto& triangle = on_.mesh.triangles[t];
      tree.for_each_within(on_.position(triangle[0]), margin * (from_first_corner + own_path),
                           [&](const auto& near) { test(triangle, candidates[near.id.index()]); });
    }
  });
}

/// Tests the triangles at each vertex against the candidates near it.
///
/// A triangle's image lies within ratio rho_a of its corner a, and within k rho_v of a candidate v
/// where it may cover it. With rho_v <= rho_a + |a - v| the corner is no farther from v than
/// (ratio + k) / (1 - k) times rho_a.
template <class Test>
void CoveringDegree::test_near_triangles(const std::vector<VertexId>& candidates, unsigned threads,
                                         Test test) const {
  std::vector<Candidate> located;
  located.reserve(candidates.size());
  double k = 0;
  for (const VertexId v : candidates) {
    located.push_back({v, on_.position(v.value), on_.vertices[v.index()].length_scale()});
    k = std::max(k, path_to_skin(v) / min_length_scale(v));
  }
  const double ratio = up * (bounds_.ratio() + k) / (1 - k);
  // The length scales on both sides are known to max_doubt, and so are their octaves.
  const CandidateGrid grid(std::max(ratio, 1e-3) + 6 * FlowBounds::max_doubt, located);
  const auto test_triangles_at = [&](std::uint32_t a) {
    const double rho = (1 + 2 * FlowBounds::max_doubt) * on_.vertices[a].length_scale();
    grid.for_each_near(on_.position(a), rho, [&](VertexId v) {
      const double farthest = up * ratio * rho;
      if ((on_.position(a) - on_.position(v.value)).squaredNorm() > farthest * farthest) return;
      connectivity_.for_each_outgoing(VertexId{a}, [&](HalfEdgeId h) {
        test({a, connectivity_.target(h).value, connectivity_.apex(h).value}, v);
      });
    });
  };
  const std::size_t count = on_.mesh.positions.size();
  geometry::for_each_block(threads, count, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t a = begin; a < end; ++a) test_triangles_at(static_cast<std::uint32_t>(a));
  });
}

std::vector<std::optional<VertexId>> CoveringDegree::proved_vertices(unsigned threads) const {
  const Candidates all = candidates();
  const std::vector<char> is_free = free_candidates(all, threads);
  std::vector<std::optional<VertexId>> result(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto free =
        std::ranges::find_if(all[i], [&](VertexId v) { return is_free[v.index()] != 0; });
    if (free != all[i].end()) result[i] = *free;
  }
  return result;
}

}  // namespace morskin::certify
