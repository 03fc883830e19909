#include "certify/covering_degree.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#include "certify/candidate_grid.h"
#include "geometry/kd_tree.h"

namespace morskin::certify {

void FlowReach::add(std::uint32_t triangle, double circumradius, double way, double rho) {
  // A point of the triangle lies within R of a corner.
  const double ratio = (circumradius + way) / rho;
  if (ratio > most) {
    const double reach = std::min<double>(2 * circumradius + way, FLT_MAX);
    far_.push_back({triangle, static_cast<float>(reach)});
    unbounded_count_ += !std::isfinite(way);
  } else {
    ratio_ = std::max(ratio_, ratio);
  }
}

void FlowReach::add(FlowReach others) {
  ratio_ = std::max(ratio_, others.ratio_);
  far_.insert(far_.end(), others.far_.begin(), others.far_.end());
  unbounded_count_ += others.unbounded_count_;
}

/// Whether the triangles round v, seen along its normal, go round it once and all the same way.
bool CoveringDegree::turns_once(VertexId v) const {
  const SurfacePoint& p = on_.points[v.index()];
  double sum = 0;
  bool is_forward = true;
  on_.connectivity.for_each_outgoing(v, [&](HalfEdgeId h) {
    Vector e = position(on_.connectivity.target(h).value) - p.position;
    Vector f = position(on_.connectivity.apex(h).value) - p.position;
    e -= e.dot(p.normal) * p.normal;
    f -= f.dot(p.normal) * p.normal;
    const double angle = std::atan2(e.cross(f).dot(p.normal), e.dot(f));
    is_forward = is_forward && angle > 0;
    sum += angle;
  });
  return is_forward && std::abs(sum - 2 * M_PI) < 1;  // a whole number of turns, so 1 is apart
}

namespace {

double squared_distance_to_triangle(const Point& x, const Point& a, const Point& b,
                                    const Point& c) {
  const Vector n = (b - a).cross(c - a);
  const std::array corner{&a, &b, &c};
  bool is_over = true;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &p = *corner[k], &q = *corner[(k + 1) % 3];
    const Vector e = q - p, d = x - p;
    is_over = is_over && e.cross(d).dot(n) >= 0;
    const double s = std::clamp(e.dot(d) / e.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (d - s * e).squaredNorm());
  }
  const double height = n.dot(x - a);
  return is_over ? height * height / n.squaredNorm() : least;
}

}  // namespace

/// Whether the flow may carry a point p of a triangle to the vertex v, which is not among its
/// corners. |G(p)| is at most R^2, and |N| is rho at v. Where the way from v has become s long, N
/// has changed by s at most, so the way's direction differs from v's normal by a sine of s / rho:
/// it ends no farther than s^2 / (2 rho) off the line along that normal.
bool CoveringDegree::may_cover(const std::array<std::uint32_t, 3>& triangle, VertexId v) const {
  const auto& [a, b, c] = triangle;
  const std::array corners{&on_.points[a], &on_.points[b], &on_.points[c]};
  const Circumcircle circle = circumcircle(position(a), position(b), position(c));
  const double residual = residual_at(corners, on_.largest_residual);
  const double g = circle.radius * circle.radius + residual;
  const SurfacePoint& at = on_.points[v.index()];
  constexpr double room = 1 + 1e-6;  // well above the rounding of either side
  double way = longest_way(at.length_scale, g);
  const double d2 =
      squared_distance_to_triangle(position(v.value), position(a), position(b), position(c));
  if (d2 > way * way * room) return false;
  way = std::min(way, prove_tube(on_.surface, corners, circle, residual).way);
  if (d2 > way * way * room) return false;
  const double aside = way * way / (2 * at.length_scale);
  const auto along_skin = [&](std::uint32_t corner) -> Point {
    const Vector d = position(corner) - position(v.value);
    return d - d.dot(at.normal) * at.normal;
  };
  const double d2_aside =
      squared_distance_to_triangle(Point::Zero(), along_skin(a), along_skin(b), along_skin(c));
  return !(d2_aside > aside * aside * room);
}

/// A few of each component, from all over it: where the mesh is thin beside its length scale a
/// neighbour's triangle may pass through the ball, and another vertex shows the degree.
CoveringDegree::Candidates CoveringDegree::candidates() const {
  constexpr std::size_t most_candidates = 16;
  Candidates result(on_.parts.count);
  std::vector<std::uint32_t> size(on_.parts.count, 0), seen(on_.parts.count, 0);
  for (const auto part : on_.parts.of_triangle) ++size[part];
  for (std::size_t t = 0; t < on_.mesh.triangles.size(); ++t) {
    const auto part = on_.parts.of_triangle[t];
    auto& list = result[part];
    const VertexId v{on_.mesh.triangles[t][0]};
    if (seen[part]++ % (size[part] / most_candidates + 1) != 0) continue;
    if (std::find(list.begin(), list.end(), v) == list.end() && turns_once(v)) list.push_back(v);
  }
  return result;
}

std::vector<char> CoveringDegree::free_candidates(const Candidates& candidates) const {
  std::vector<VertexId> all;
  for (const auto& list : candidates) all.insert(all.end(), list.begin(), list.end());
  // A triangle that is not proved may reach anywhere, and is held against every candidate.
  constexpr std::size_t most_looks = 1'000'000'000;
  if (reach_.unbounded_count() > most_looks / std::max<std::size_t>(all.size(), 1)) return {};
  std::vector<char> is_free(on_.mesh.positions.size(), 0);
  for (const VertexId v : all) is_free[v.index()] = 1;
  const auto look_at = [&](const std::array<std::uint32_t, 3>& t, VertexId v) {
    const bool is_own = t[0] == v.value || t[1] == v.value || t[2] == v.value;
    if (!is_own && is_free[v.index()] && may_cover(t, v)) is_free[v.index()] = 0;
  };
  look_from_far(all, look_at);
  look_from_near(all, look_at);
  return is_free;
}

/// Looks at the candidates that the triangles which reach far may come to.
template <class Look>
void CoveringDegree::look_from_far(const std::vector<VertexId>& candidates, Look look_at) const {
  if (reach_.far().empty()) return;
  std::vector<Point> places;
  places.reserve(candidates.size());
  for (const VertexId v : candidates) places.push_back(position(v.value));
  const geometry::KdTree<VertexId> tree(places);
  constexpr double room = 1.01;  // far above the rounding to single precision
  for (const auto& [t, from_first_corner] : reach_.far()) {
    const auto& triangle = on_.mesh.triangles[t];
    tree.for_each_within(position(triangle[0]), room * from_first_corner,
                         [&](const auto& near) { look_at(triangle, candidates[near.id.index()]); });
  }
}

/// Each vertex looks for candidates near it, and holds its triangles against them.
template <class Look>
void CoveringDegree::look_from_near(const std::vector<VertexId>& candidates, Look look_at) const {
  std::vector<Candidate> placed;
  placed.reserve(candidates.size());
  for (const VertexId v : candidates) {
    placed.push_back({v, position(v.value), on_.points[v.index()].length_scale});
  }
  const CandidateGrid grid(std::max(reach_.ratio(), 1e-3), placed);
  for (std::uint32_t a = 0; a < on_.mesh.positions.size(); ++a) {
    grid.for_each_near(position(a), on_.points[a].length_scale, [&](VertexId v) {
      const double farthest = 1.01 * reach_.ratio() * on_.points[a].length_scale;
      if ((position(a) - position(v.value)).squaredNorm() > farthest * farthest) return;
      on_.connectivity.for_each_outgoing(VertexId{a}, [&](HalfEdgeId h) {
        look_at({a, on_.connectivity.target(h).value, on_.connectivity.apex(h).value}, v);
      });
    });
  }
}

std::optional<std::size_t> CoveringDegree::first_not_shown() const {
  const Candidates all = candidates();
  const std::vector<char> is_free = free_candidates(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_shown = !is_free.empty() && std::ranges::any_of(all[i], [&](VertexId v) {
      return is_free[v.index()] != 0;
    });
    if (!is_shown) return i;
  }
  return std::nullopt;
}

}  // namespace morskin::certify
