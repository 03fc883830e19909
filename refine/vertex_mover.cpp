#include "refine/vertex_mover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "certify/tube.h"
#include "geometry/orthogonal.h"

namespace morskin::refine {

namespace {

/// Tried from a position: so many directions, at steps from a quarter of the shortest edge down to
/// a tenth of that.
constexpr int directions = 8;
constexpr double longest_step = 0.25, shortest_step = 0.025;

/// A move must raise the worst triangle's quality by this factor, so that moves end.
constexpr double min_gain = 1.001;

/// What is asked of a triangle.
struct Shape {
  double quality;  ///< AngleGoal::quality()
  double radius;   ///< of its circumcircle, Angstrom
  Vector normal;   ///< twice its area long
};
Shape shape(const Point& a, const Point& b, const Point& c, const AngleGoal& goal) {
  const Vector n = (b - a).cross(c - a);
  const double nn = n.squaredNorm();
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  return {goal.quality(nn, ab, bc, ca), std::sqrt(ab * bc * ca / nn) / 2, n};
}

}  // namespace

/// Lists the vertices around v, counter-clockwise, and those beyond the edges between them.
/// @return whether v may move, and none of these may be moved by another. Those around share a
///         triangle with v, so no other moves them.
bool VertexMover::gather_neighbours(VertexId v) {
  ring_.clear();
  beyond_.clear();
  mesh_.surface.for_each_outgoing(v, [&](HalfEdgeId h) {
    ring_.push_back(mesh_.surface.target(h));
    beyond_.push_back(mesh_.surface.apex(mesh_.surface.twin(SurfaceMesh::next(h))));
  });
  return subdomain_.contains(v) &&
         std::ranges::all_of(beyond_, [&](VertexId x) { return subdomain_.is_safe_to_read(x); });
}

/// The least quality around v were it at x; nothing unless it is above `asked`, [L] and [U] hold
/// and all triangles face outward.
std::optional<double> VertexMover::quality(const SurfacePoint& x, double asked) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const SurfacePoint& p = mesh_.at(ring_[i]);
    const SurfacePoint& q = mesh_.at(ring_[(i + 1) % ring_.size()]);
    const Shape s = shape(x.position, p.position, q.position, goal_);
    const double rho = surface::min_length_scale({&x, &p, &q});
    const bool is_good = s.quality > asked && !sizing_.is_too_short(x, p) &&
                         sizing_.triangle_ratio(s.radius, rho) < 1 && is_upright(s.normal, x, p, q);
    if (!is_good) return std::nullopt;
    least = std::min(least, s.quality);
  }
  return least;
}

/// Whether the certificate can prove the triangles around v were it at x, where [U] does not see
/// to it.
bool VertexMover::keeps_provable(const SurfacePoint& x) const {
  if (sizing_.is_tube_proved()) return true;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const SurfacePoint& p = mesh_.at(ring_[i]);
    const SurfacePoint& q = mesh_.at(ring_[(i + 1) % ring_.size()]);
    const Circumcircle circle = circumcircle(x.position, p.position, q.position);
    const double residual = surface_.residual_bound(x.length_scale);
    if (!expects_tube(surface_, {&x, &p, &q}, circle, residual)) return false;
  }
  return true;
}

/// Whether the surface balls around v stay empty of their neighbours' corners were it at x.
bool VertexMover::keeps_delaunay(const SurfacePoint& x) const {
  const auto ball = [this](const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c) {
    const Circumcircle circle = circumcircle(a.position, b.position, c.position);
    return LazySurfaceBall(surface_, {&a, &b, &c}, circle);
  };
  const auto is_entered = [](LazySurfaceBall& by, const SurfacePoint& p) {
    return by.intrusion(p.position).max > 0;
  };
  const std::size_t n = ring_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SurfacePoint &p = mesh_.at(ring_[i]), &q = mesh_.at(ring_[(i + 1) % n]);
    const SurfacePoint& beyond = mesh_.at(beyond_[i]);
    LazySurfaceBall inner = ball(x, p, q), outer = ball(beyond, q, p);
    if (is_entered(outer, x) || is_entered(inner, beyond) ||
        is_entered(inner, mesh_.at(ring_[(i + n - 1) % n])) ||
        is_entered(inner, mesh_.at(ring_[(i + 2) % n]))) {
      return false;
    }
  }
  return true;
}

/// The best position a step away from x; nothing if none is better than `asked`.
std::optional<std::pair<double, SurfacePoint>> VertexMover::step_from(const SurfacePoint& x,
                                                                      double step,
                                                                      double asked) const {
  const geometry::TangentFrame tangent(x.normal);
  std::vector<std::pair<double, SurfacePoint>> better;
  for (int k = 0; k < directions; ++k) {
    const double angle = 2 * M_PI * k / directions;
    const auto y = surface_.project(x.position + step * tangent.direction(angle), x.cell);
    if (!y) continue;
    if (const auto q = quality(*y, asked)) better.emplace_back(*q, *y);
  }
  std::stable_sort(better.begin(), better.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  const auto found = std::find_if(better.begin(), better.end(), [this](const auto& b) {
    return keeps_provable(b.second) && keeps_delaunay(b.second);
  });
  return found == better.end() ? std::nullopt : std::optional(*found);
}

VertexMover::Moved VertexMover::move(VertexId v) {
  if (!gather_neighbours(v)) return Moved::NotMine;
  SurfacePoint& at = mesh_.points[v];
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double now = infinity, shortest = infinity;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Point& p = mesh_.position(ring_[i]);
    const Point& q = mesh_.position(ring_[(i + 1) % ring_.size()]);
    now = std::min(now, goal_.quality(at.position, p, q));
    shortest = std::min(shortest, (p - at.position).norm());
  }
  bool has_moved = false;
  for (double step = longest_step * shortest; step > shortest_step * shortest && now < 1;) {
    if (const auto found = step_from(at, step, min_gain * now)) {
      std::tie(now, at) = *found;
      has_moved = true;
    } else {
      step /= 2;
    }
  }
  return has_moved ? Moved::Yes : Moved::No;
}

}  // namespace morskin::refine
