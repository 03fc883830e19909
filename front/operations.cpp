// The operations of section 4.1: creation, creep, wing, bridge, seal.

#include <algorithm>
#include <array>
#include <cmath>

#include "front/sweep.h"

namespace morskin::front {

/// Creation: lays a bowl of six triangles, at a minimum as a rule, unless another bowl is so near
/// that its front will run over it.
void Sweep::create(const SurfacePoint& p0) {
  guard_.gather(p0);
  if (!guard_.is_bare_within(disk_.spacing().bowl_gap * disk_.radius(p0.length_scale))) return;
  // [excerpt: bowl]
  std::array<SurfacePoint, 6> rim;
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = static_cast<double>(i) * sixty_degrees;
    const Vector2 direction(std::cos(angle), std::sin(angle));
    const auto x = disk_.rim_point(p0, guard_.in_tangent_plane(direction));
    if (!x) return;
    rim[i] = *x;
  }
  front_.open_fan(p0, rim);
  // [/excerpt]
  done(Operation::Creation);
}

/// Creep: fills the bare angle at a departure vertex, with new vertices as far as the guard lets
/// them pass, and closes it with existing ones.
/// @return whether it could be closed
bool Sweep::creep(const Departure& t) {
  const FrontEdgeId e = t.corner;
  const SurfacePoint centre = mesh_.at(front_[e].origin);
  inspect(e);
  fresh_.restart(front_[e].next);
  if (!front_.is_triangle(e)) {
    break_long_edge(e, centre);
    break_long_edge(front_[e].previous, centre);
  }
  while (departures_.is_current(t)) {
    const double angle = guard_.bare_angle(e);
    double sectors = disk_.spacing().sectors(angle);
    if (sectors < 2 && angle > 0 && !is_ear_small(e)) sectors = 2;
    if (sectors >= 2 && !front_.is_triangle(e)) {
      lay_fan(e, centre, angle / sectors, static_cast<int>(sectors) - 1);
    }
    const auto apex = last_apex(e);
    if (!apex) return false;
    front_.finish_edge(e, *apex);
  }
  done(Operation::Creep);
  wing();
  return true;
}

/// Lays triangles with new vertices round the departure vertex, clockwise from edge e, each turned
/// on by the same angle, until the next would come too near to the front.
// [excerpt: fan]
void Sweep::lay_fan(FrontEdgeId e, const SurfacePoint& centre, double angle, int count) {
  const double r = disk_.radius(centre.length_scale);
  const double c = std::cos(angle), s = std::sin(angle);
  Vector2 direction = guard_.local(front_.next(e).position).plane.normalized();
  for (int i = 0; i < count; ++i) {
    direction =
        Vector2(c * direction.x() + s * direction.y(), c * direction.y() - s * direction.x());
    if (!attach_new(e, disk_.rim_point(centre, guard_.in_tangent_plane(direction)), r)) return;
  }
}
// [/excerpt]

/// Adds the triangle of edge e and a new vertex x, if the guard lets it pass.
bool Sweep::attach_new(FrontEdgeId e, const std::optional<SurfacePoint>& x, double r) {
  const Spacing& spacing = disk_.spacing();
  if (!x || !guard_.is_clear(e, guard_.local(x->position), spacing.vertex_gap * r,
                             spacing.edge_gap * r)) {
    return false;
  }
  front_.attach(e, *x);
  return true;
}

/// Lays a triangle with a vertex before the middle of an edge at the departure vertex that is too
/// long for its ends.
void Sweep::break_long_edge(FrontEdgeId e, const SurfacePoint& centre) {
  const double squared_length = (front_.next(e).position - front_[e].position).squaredNorm();
  if (!disk_.may_edge_be_long(centre.length_scale, std::sqrt(squared_length))) return;
  const SurfacePoint &p = mesh_.at(front_[e].origin), &w = mesh_.at(front_.target(e));
  if (!disk_.is_edge_long(p, w, squared_length)) return;
  const double r = disk_.radius(std::min(p.length_scale, w.length_scale));
  const Vector2 at_p = guard_.local(p.position).plane, at_w = guard_.local(w.position).plane;
  const Vector2 along = (at_w - at_p).normalized();
  const Vector2 right(along.y(), -along.x());
  const Vector2 x = (at_p + at_w) / 2 + disk_.spacing().long_edge_height * r * right;
  attach_new(e, disk_.projected(guard_.in_space(x), p.cell), r);
}

/// Wing: closes the small angles among the corners that the last operation changed, and those that
/// this makes small in turn.
// [excerpt: wing]
void Sweep::wing() {
  while (const auto corner = fresh_.next()) {
    const FrontEdgeId c = *corner;
    if (!front_[c].is_open || !guard_.is_acute(c, disk_.wing_cosine())) continue;
    const certify::Circumcircle circle = ear(c);
    if (!disk_.is_ear_small(circle, mesh_.at(front_[c].origin))) continue;
    // One closed corner makes the next one small, and so on out of view. A corner whose circle is
    // not all in view waits for its own turn.
    if (!guard_.is_in_view(circle.centre, circle.radius)) continue;
    if (guard_.delaunay_apex(c) != front_[c].previous) continue;
    front_.close_corner(c);
    done(Operation::Wing);
  }
}
// [/excerpt]

/// Bridge: joins the two sides of a saddle that the front has reached from both, over the first
/// edge that sees the other side: those of one side come first, each side's as they were marked.
/// From then on its surroundings are ordinary, also where no edge does.
void Sweep::bridge(CriticalId saddle) {
  const Marks::Sides sides = marks_.release(saddle);
  for (const auto& side : sides) departures_.put_back(side);
  for (const std::size_t side : {0U, 1U}) {
    for (const Departure& t : sides[side]) {
      if (departures_.is_current(t) && bridge_from(t, saddle, side)) return;
    }
  }
}

// [excerpt: bridge]
bool Sweep::bridge_from(const Departure& t, CriticalId saddle, std::size_t side) {
  inspect(t.corner);
  for (const FrontEdgeId e : {t.corner, front_[t.corner].previous}) {
    const auto apex = guard_.delaunay_apex(e);
    if (!apex) continue;
    const VertexId v = front_[*apex].origin;
    const bool is_across =
        guide_.spheres.containing(mesh_.at(v)) == saddle && side_of_saddle(saddle, v) != side;
    if (!is_across) continue;
    fresh_.restart(front_[e].next);
    front_.finish_edge(e, *apex);
    done(Operation::Bridge);
    wing();
    return true;
  }
  return false;
}
// [/excerpt]

/// Seal: closes the hole round a maximum with triangles over neighbouring edges; the refinement
/// breaks those that are too big (section 4.3).
void Sweep::seal(CriticalId maximum) {
  bool is_sealed = false;
  const Marks::Sides green = marks_.release(maximum);
  for (const Departure& t : green[0]) {
    // [excerpt: seal]
    while (departures_.is_current(t)) {
      inspect(t.corner);
      const auto apex = last_apex(t.corner);
      if (!apex) {
        defer(t);
        break;
      }
      front_.finish_edge(t.corner, *apex);
      is_sealed = true;
    }
    // [/excerpt]
  }
  if (is_sealed) done(Operation::Seal);
}

}  // namespace morskin::front
