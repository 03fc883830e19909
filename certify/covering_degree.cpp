#include "certify/covering_degree.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#include "certify/candidate_grid.h"
#include "geometry/kd_tree.h"

namespace morskin::certify {

void FlowBounds::add(std::uint32_t triangle, double circumradius, double max_path, double rho) {
  // A point of the triangle lies within R of a corner.
  const double ratio = (circumradius + max_path) / rho;
  if (ratio > max_ratio) {
    const double distance = std::min<double>(2 * circumradius + max_path, FLT_MAX);
    far_.push_back({triangle, static_cast<float>(distance)});
    unbounded_count_ += !std::isfinite(max_path);
  } else {
    ratio_ = std::max(ratio_, ratio);
  }
}

void FlowBounds::add(FlowBounds others) {
  ratio_ = std::max(ratio_, others.ratio_);
  far_.insert(far_.end(), others.far_.begin(), others.far_.end());
  unbounded_count_ += others.unbounded_count_;
}

/// Whether the triangles at v, seen along its normal, all turn forward and make one full turn.
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
  return is_forward && std::abs(sum - 2 * M_PI) < 1;  // sum is a multiple of 2 pi
}

namespace {

double squared_distance_to_triangle(const Point& x, const Point& a, const Point& b,
                                    const Point& c) {
  const Vector n = (b - a).cross(c - a);
  const std::array corner{&a, &b, &c};
  bool is_over = true;
  double to_edges = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Point &p = *corner[k], &q = *corner[(k + 1) % 3];
    const Vector e = q - p, d = x - p;
    is_over = is_over && e.cross(d).dot(n) >= 0;
    const double s = std::clamp(e.dot(d) / e.squaredNorm(), 0.0, 1.0);
    to_edges = std::min(to_edges, (d - s * e).squaredNorm());
  }
  const double height = n.dot(x - a);
  return is_over ? height * height / n.squaredNorm() : to_edges;
}

}  // namespace

/// Whether the flow may carry a point p of a triangle to the vertex v, not one of its corners.
/// |G(p)| is at most R^2, and |N| is rho at v. On a path of length s from v N changes by at most s,
/// so the path's direction differs from v's normal by a sine of at most s / rho: it ends within
/// s^2 / (2 rho) of the line along that normal.
bool CoveringDegree::may_cover(const std::array<std::uint32_t, 3>& triangle, VertexId v) const {
  const auto& [a, b, c] = triangle;
  const std::array corners{&on_.points[a], &on_.points[b], &on_.points[c]};
  const Circumcircle circle = circumcircle(position(a), position(b), position(c));
  const double residual = max_residual(corners, on_.max_residual_ratio);
  const double g = circle.radius * circle.radius + residual;
  const SurfacePoint& at = on_.points[v.index()];
  constexpr double margin = 1 + 1e-6;  // well above the rounding of either side
  double path = max_flow_path(at.length_scale, g);
  const double d2 =
      squared_distance_to_triangle(position(v.value), position(a), position(b), position(c));
  if (d2 > path * path * margin) return false;
  path = std::min(path, prove_tube(on_.surface, corners, circle, residual).max_path);
  if (d2 > path * path * margin) return false;
  const double aside = path * path / (2 * at.length_scale);
  const auto along_skin = [&](std::uint32_t corner) -> Point {
    const Vector d = position(corner) - position(v.value);
    return d - d.dot(at.normal) * at.normal;
  };
  const double d2_aside =
      squared_distance_to_triangle(Point::Zero(), along_skin(a), along_skin(b), along_skin(c));
  return !(d2_aside > aside * aside * margin);
}

/// A few of each component, spread over it: where the surface is thin against its length scale,
/// triangles of another sheet may cover some of them.
CoveringDegree::Candidates CoveringDegree::candidates() const {
  constexpr std::size_t max_candidates = 16;
  const geometry::Components& components = on_.components;
  Candidates result(components.count);
  std::vector<std::uint32_t> size(components.count, 0), seen(components.count, 0);
  for (const auto c : components.of_triangle) ++size[c];
  for (std::size_t t = 0; t < on_.mesh.triangles.size(); ++t) {
    const auto c = components.of_triangle[t];
    auto& list = result[c];
    const VertexId v{on_.mesh.triangles[t][0]};
    if (seen[c]++ % (size[c] / max_candidates + 1) != 0) continue;
    if (std::find(list.begin(), list.end(), v) == list.end() && turns_once(v)) list.push_back(v);
  }
  return result;
}

std::vector<char> CoveringDegree::free_candidates(const Candidates& candidates) const {
  std::vector<VertexId> all;
  for (const auto& list : candidates) all.insert(all.end(), list.begin(), list.end());
  // An unbounded triangle is tested against every candidate.
  constexpr std::size_t max_tests = 1'000'000'000;
  if (bounds_.unbounded_count() > max_tests / std::max<std::size_t>(all.size(), 1)) return {};
  std::vector<char> is_free(on_.mesh.positions.size(), 0);
  for (const VertexId v : all) is_free[v.index()] = 1;
  const auto test = [&](const std::array<std::uint32_t, 3>& t, VertexId v) {
    const bool is_own = t[0] == v.value || t[1] == v.value || t[2] == v.value;
    if (!is_own && is_free[v.index()] && may_cover(t, v)) is_free[v.index()] = 0;
  };
  test_far_triangles(all, test);
  test_near_triangles(all, test);
  return is_free;
}

/// Tests each far triangle against the candidates within its bound.
template <class Test>
void CoveringDegree::test_far_triangles(const std::vector<VertexId>& candidates, Test test) const {
  if (bounds_.far().empty()) return;
  std::vector<Point> positions;
  positions.reserve(candidates.size());
  for (const VertexId v : candidates) positions.push_back(position(v.value));
  const geometry::KdTree<VertexId> tree(positions);
  constexpr double margin = 1.01;  // far above the rounding to single precision
  for (const auto& [t, from_first_corner] : bounds_.far()) {
    const auto& triangle = on_.mesh.triangles[t];
    tree.for_each_within(position(triangle[0]), margin * from_first_corner,
                         [&](const auto& near) { test(triangle, candidates[near.id.index()]); });
  }
}

/// Tests the triangles at each vertex against the candidates near it.
template <class Test>
void CoveringDegree::test_near_triangles(const std::vector<VertexId>& candidates, Test test) const {
  std::vector<Candidate> located;
  located.reserve(candidates.size());
  for (const VertexId v : candidates) {
    located.push_back({v, position(v.value), on_.points[v.index()].length_scale});
  }
  const CandidateGrid grid(std::max(bounds_.ratio(), 1e-3), located);
  for (std::uint32_t a = 0; a < on_.mesh.positions.size(); ++a) {
    grid.for_each_near(position(a), on_.points[a].length_scale, [&](VertexId v) {
      const double farthest = 1.01 * bounds_.ratio() * on_.points[a].length_scale;
      if ((position(a) - position(v.value)).squaredNorm() > farthest * farthest) return;
      on_.connectivity.for_each_outgoing(VertexId{a}, [&](HalfEdgeId h) {
        test({a, on_.connectivity.target(h).value, on_.connectivity.apex(h).value}, v);
      });
    });
  }
}

std::optional<std::size_t> CoveringDegree::first_unproved() const {
  const Candidates all = candidates();
  const std::vector<char> is_free = free_candidates(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_proved = !is_free.empty() && std::ranges::any_of(all[i], [&](VertexId v) {
      return is_free[v.index()] != 0;
    });
    if (!is_proved) return i;
  }
  return std::nullopt;
}

}  // namespace morskin::certify
