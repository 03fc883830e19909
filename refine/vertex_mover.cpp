#include "refine/vertex_mover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "geometry/orthogonal.h"

namespace morskin::refine {

namespace {

/// Tried from a position: so many directions, at steps from a quarter of the shortest edge down to
/// a tenth of that.
constexpr std::size_t directions = 8;
constexpr double longest_step = 0.25, shortest_step = 0.025;

/// A move must raise the worst triangle's quality by this factor, so that moves end.
constexpr double min_gain = 1.001;

/// Cosine and sine of each direction's angle.
std::array<std::pair<double, double>, directions> rim() {
  std::array<std::pair<double, double>, directions> points;
  for (std::size_t k = 0; k < directions; ++k) {
    const double angle = 2 * M_PI * static_cast<double>(k) / directions;
    points[k] = {std::cos(angle), std::sin(angle)};
  }
  return points;
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

/// The least quality around v were it at x; negative if it is not above `asked`.
double VertexMover::quality(const Point& x, double asked) const {
  double least = std::numeric_limits<double>::infinity();
  VertexId last = ring_.back();
  for (const VertexId v : ring_) {
    const double one = goal_.quality(x, mesh_.position(last), mesh_.position(v));
    if (!(one > asked)) return -1;
    least = std::min(least, one);
    last = v;
  }
  return least;
}

/// Whether [L] and [U] hold around v and all triangles face outward were it at x.
bool VertexMover::keeps_size(const SurfacePoint& x) const {
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const SurfacePoint& p = mesh_.at(ring_[i]);
    const SurfacePoint& q = mesh_.at(ring_[(i + 1) % ring_.size()]);
    const Vector to_p = p.position - x.position, to_q = q.position - x.position;
    const Vector normal = to_p.cross(to_q);
    const double radius = to_p.norm() * to_q.norm() * (to_q - to_p).norm() / (2 * normal.norm());
    const double rho = surface::min_length_scale({&x, &p, &q});
    if (sizing_.is_too_short(x, p) || !(sizing_.triangle_ratio(radius, rho) < 1) ||
        !is_upright(normal, x, p, q)) {
      return false;
    }
  }
  return true;
}

/// Whether the certificate can prove the triangles around v were it at x.
/// @pre keeps_size(x)
bool VertexMover::keeps_provable(const SurfacePoint& x) const {
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const SurfacePoint& p = mesh_.at(ring_[i]);
    const SurfacePoint& q = mesh_.at(ring_[(i + 1) % ring_.size()]);
    if (!expects_tube(surface_, sizing_, {&x, &p, &q})) return false;
  }
  return true;
}

/// Whether the surface balls around v stay empty of their neighbours' corners were it at x.
bool VertexMover::keeps_delaunay(const SurfacePoint& x) const {
  const auto ball = [this](const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c) {
    return LazySurfaceBall(surface_, {&a, &b, &c}, circumcircle({&a, &b, &c}));
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

/// The best position a step away from x; nothing if none is better than `asked`. Directions are
/// ranked in the tangent plane: to project is dear, and moves a point by a small share of the step.
std::optional<std::pair<double, SurfacePoint>> VertexMover::step_from(const SurfacePoint& x,
                                                                      double step,
                                                                      double asked) const {
  static const auto rim = morskin::refine::rim();
  const geometry::TangentFrame tangent(x.normal);
  std::array<Point, directions> at;
  std::array<double, directions> in_plane;
  for (std::size_t k = 0; k < directions; ++k) {
    const auto [cosine, sine] = rim[k];
    at[k] = x.position + step * (cosine * tangent.first + sine * tangent.second);
    in_plane[k] = quality(at[k], asked);
  }
  for (;;) {
    const auto best = std::ranges::max_element(in_plane);
    if (*best < 0) return std::nullopt;
    *best = -1;
    const auto y = surface_.project(at[static_cast<std::size_t>(best - in_plane.begin())], x.cell);
    if (!y) continue;
    const double on_surface = quality(y->position, asked);
    if (on_surface > 0 && keeps_size(*y) && keeps_provable(*y) && keeps_delaunay(*y)) {
      return std::pair(on_surface, *y);
    }
  }
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

bool VertexMover::even_out(VertexId v) {
  if (!gather_neighbours(v)) return false;
  SurfacePoint& at = mesh_.points[v];
  Vector sum = Vector::Zero();
  double weights = 0;
  for (const VertexId x : ring_) {
    const SurfacePoint& p = mesh_.at(x);
    const Vector to_p = p.position - at.position;
    const double weight = to_p.norm() / (at.length_scale + p.length_scale);
    sum += weight * to_p;
    weights += weight;
  }
  const Vector step = sum / weights;
  const auto y = surface_.project(at.position + step - at.normal.dot(step) * at.normal, at.cell);
  if (!y || !keeps_size(*y)) return false;
  at = *y;
  return true;
}

}  // namespace morskin::refine
