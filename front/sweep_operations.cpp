// The operations of section 4.1: creation, creep, wing, bridge, seal.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "front/sweep.h"

namespace morskin::front {

namespace {

constexpr double sixty_degrees = M_PI / 3;

}  // namespace

/// The disk's radius in one direction: for the smaller of the length scales at both ends, which is
/// the one that [U] goes by. The far end's is read off the patch, which mostly goes on.
// [excerpt: disk]
double Sweep::disk_radius(const SurfacePoint& centre, const Vector& direction) const {
  const double r = disk_share_ * options_.sizing.scale(centre.length_scale);
  const double far = skin_.length_scale(centre.position + r * direction, centre.cell);
  return disk_share_ * options_.sizing.scale(std::min(centre.length_scale, far));
}

std::optional<SurfacePoint> Sweep::rim_point(const SurfacePoint& centre, const Vector2& direction) {
  const Vector d = near_.in_tangent_plane(direction);
  return skin_.project(centre.position + disk_radius(centre, d) * d, centre.cell);
}
// [/excerpt]

void Sweep::create(const morse::CriticalPoint& minimum) {
  near_.gather(minimum.point);
  // A minimum this near to a bowl is left for its front to run over.
  constexpr double least_gap = 1.9;
  const double r = disk_share_ * options_.sizing.scale(minimum.point.length_scale);
  bool is_bare = true;
  front_.grid().for_each_within(
      minimum.point.position, minimum.point.length_scale,
      std::min(least_gap * r, front_.grid().reach(minimum.point.length_scale)), [&](FrontEdgeId e) {
        const Vector d = front_[e].position - minimum.point.position;
        is_bare = is_bare && d.squaredNorm() > least_gap * r * least_gap * r;
      });
  if (!is_bare) return;
  // [excerpt: bowl]
  std::array<SurfacePoint, 6> rim;
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = static_cast<double>(i) * sixty_degrees;
    const auto x = rim_point(minimum.point, Vector2(std::cos(angle), std::sin(angle)));
    if (!x) return;
    rim[i] = *x;
  }
  auto& surface = mesh_.surface;
  const VertexId p0 = mesh_.add_vertex(minimum.point);
  std::array<VertexId, 6> p;
  for (std::size_t i = 0; i < 6; ++i) p[i] = mesh_.add_vertex(rim[i]);
  std::array<HalfEdgeId, 6> boundary;
  std::array<HalfEdgeId, 6> spokes_in, spokes_out;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto t = surface.add_triangle(p0, p[i], p[(i + 1) % 6]);
    spokes_out[i] = geometry::SurfaceMesh::half_edge(t, 0);
    boundary[i] = geometry::SurfaceMesh::half_edge(t, 1);
    spokes_in[i] = geometry::SurfaceMesh::half_edge(t, 2);
  }
  for (std::size_t i = 0; i < 6; ++i) surface.glue(spokes_in[i], spokes_out[(i + 1) % 6]);
  // [/excerpt]
  for (const FrontEdgeId e : front_.open_polygon(boundary)) push(e);
  ++operations_.creation;
  note(Operation::Creation);
}

/// Adds the triangle of edge e and the vertex of an existing corner, wherever that is.
void Sweep::attach(FrontEdgeId e, FrontEdgeId corner) {
  const FrontEdgeId after = front_[e].next;
  if (corner == front_[e].previous) {
    close_corner(e);
  } else if (front_[corner].previous == after) {
    close_corner(after);
  } else {
    const VertexId p = front_[e].origin, v = front_[corner].origin;
    const bool is_predicted = is_protected(p) || is_protected(v);
    ++(is_predicted ? operations_.guard_inside_protecting : operations_.guard_outside_protecting);
    const FrontEdgeId added = front_.attach(e, corner);
    front_.watch_touch(e, added, is_predicted);
    near_.refresh(e);
    near_.refresh(added);
    push(added);
    fresh_.insert(fresh_.end(), {added, corner});
  }
}

void Sweep::close_corner(FrontEdgeId corner) {
  const FrontEdgeId before = front_[corner].previous, after = front_[corner].next;
  front_.close_corner(corner);
  near_.forget(corner);
  if (front_[before].is_open) {
    near_.refresh(before);
    fresh_.insert(fresh_.end(), {before, after});
  } else {
    near_.forget(before);
    near_.forget(after);
  }
}

bool Sweep::creep(FrontEdgeId e) {
  const SurfacePoint centre = mesh_.at(front_[e].origin);
  const std::uint32_t generation = front_[e].generation;
  look_round(e);
  fresh_.assign({front_[e].next});
  if (!is_triangle(e)) {
    break_long_edge(e, centre);
    break_long_edge(front_[e].previous, centre);
  }
  while (front_[e].is_open && front_[e].generation == generation) {
    const double angle = near_.bare_angle(e);
    double sectors = std::round(angle / sixty_degrees);
    if (sectors < 2 && angle > 0 && !is_ear_small(e)) sectors = 2;
    if (sectors >= 2 && !is_triangle(e))
      lay_fan(e, centre, angle / sectors, static_cast<int>(sectors) - 1);
    const auto apex = last_apex(e);
    if (!apex) return false;
    attach(e, *apex);
  }
  ++operations_.creep;
  note(Operation::Creep);
  wing();
  return true;
}

/// Lays triangles with new vertices round the departure vertex, clockwise from edge e, each turned
/// on by the same angle, until the next would come too near to the front.
// [excerpt: fan]
void Sweep::lay_fan(FrontEdgeId e, const SurfacePoint& centre, double angle, int count) {
  const double r = disk_share_ * options_.sizing.scale(centre.length_scale);
  const double c = std::cos(angle), s = std::sin(angle);
  Vector2 direction = near_.local(front_.next(e).position).plane.normalized();
  for (int i = 0; i < count; ++i) {
    direction =
        Vector2(c * direction.x() + s * direction.y(), c * direction.y() - s * direction.x());
    if (!attach_new(e, rim_point(centre, direction), r)) return;
  }
}
// [/excerpt]

/// Adds the triangle of edge e and a new vertex x if the front leaves room for it.
bool Sweep::attach_new(FrontEdgeId e, const std::optional<SurfacePoint>& x, double r) {
  if (!x || !near_.is_clear(e, near_.local(x->position), spacing_.vertex_gap * r,
                            spacing_.edge_gap * r)) {
    return false;
  }
  const FrontEdgeId added = front_.attach(e, *x);
  near_.refresh(e);
  near_.refresh(added);
  push(added);
  fresh_.push_back(added);
  is_overlapping_ |= is_covered_twice(*x);
  return true;
}

/// Lays a triangle with a vertex before the middle of an edge at the departure vertex that is too
/// long for its ends.
void Sweep::break_long_edge(FrontEdgeId e, const SurfacePoint& centre) {
  const Vector edge = front_.next(e).position - front_[e].position;
  const double squared_length = edge.squaredNorm();
  // Mostly the edge is short enough for any length scale that the far end can have: rho is
  // 1-Lipschitz.
  const double share = spacing_.longest_edge * disk_share_, length = std::sqrt(squared_length);
  if (length <= share * options_.sizing.scale(centre.length_scale - length)) return;
  const SurfacePoint &p = mesh_.at(front_[e].origin), &w = mesh_.at(front_.target(e));
  const double r = disk_share_ * options_.sizing.scale(std::min(p.length_scale, w.length_scale));
  const double longest = spacing_.longest_edge * r;
  if (squared_length <= longest * longest) return;
  const Vector2 at_p = near_.local(p.position).plane, at_w = near_.local(w.position).plane;
  const Vector2 along = (at_w - at_p).normalized();
  const Vector2 right(along.y(), -along.x());
  const Vector2 x = (at_p + at_w) / 2 + spacing_.long_edge_height * r * right;
  attach_new(e, skin_.project(near_.in_space(x), p.cell), r);
}

/// The circle through a corner and its two neighbours.
certify::Circumcircle Sweep::ear(FrontEdgeId corner) const {
  return certify::circumcircle(front_[corner].position, front_.previous(corner).position,
                               front_.next(corner).position);
}

/// Whether the triangle that closes a corner is not much bigger than those of a fan there.
bool Sweep::is_ear_small(FrontEdgeId corner) const {
  const double rho = options_.sizing.scale(mesh_.at(front_[corner].origin).length_scale);
  return ear(corner).radius <= spacing_.largest_ear * disk_share_ * rho;
}

/// Whether the polygon of an edge has three edges.
bool Sweep::is_triangle(FrontEdgeId e) const {
  return front_[front_[e].previous].previous == front_[e].next;
}

/// The existing vertex to finish edge e with. Three edges are a triangle, however flat: what it
/// lacks in shape the flips of the refinement make good.
std::optional<FrontEdgeId> Sweep::last_apex(FrontEdgeId e) const {
  return is_triangle(e) ? front_[e].previous : near_.delaunay_apex(e);
}

/// Closes the small angles among the corners that the last operation changed, and those that this
/// makes small in turn.
// [excerpt: wing]
void Sweep::wing() {
  std::size_t unchanged = 0;  // the first corner looked at since one was closed
  for (std::size_t i = 0; i < fresh_.size(); ++i) {
    const FrontEdgeId c = fresh_[i];
    const auto here = fresh_.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(fresh_.begin() + static_cast<std::ptrdiff_t>(unchanged), here, c) != here)
      continue;
    if (!front_[c].is_open || !near_.is_acute(c, wing_cosine_) || !is_ear_small(c)) continue;
    // One closed corner makes the next one small, and so on out of view: what lies there is not
    // known. Such a corner waits for its own turn.
    const certify::Circumcircle circle = ear(c);
    if (!near_.is_in_view(circle.centre, circle.radius)) continue;
    if (near_.delaunay_apex(c) != front_[c].previous) continue;
    close_corner(c);
    unchanged = i + 1;
    ++operations_.wing;
    note(Operation::Wing);
  }
}
// [/excerpt]

int Sweep::side_of_saddle(CriticalId saddle, VertexId v) const {
  const morse::CriticalPoint& s = guide_.points[saddle.index()];
  return s.descending.dot(mesh_.position(v) - s.point.position) > 0 ? 1 : 0;
}

bool Sweep::is_protected(VertexId v) const {
  const auto c = guide_.spheres.containing(mesh_.at(v));
  return c && guide_.points[c->index()].index != 0;
}

/// Joins the two fronts at a saddle that both have reached, over the lowest edge that sees the
/// other side. From then on its surroundings are ordinary.
void Sweep::bridge(CriticalId saddle) {
  Marked& marked = marked_[saddle.index()];
  marked.is_done = true;
  bool is_bridged = false;
  for (const std::size_t side : {0U, 1U}) {
    for (const Departure& d : marked.sides[side]) {
      if (!is_current(d)) continue;
      queue_.push(d);
      if (is_bridged) continue;
      look_round(d.corner);
      // [excerpt: bridge]
      for (const FrontEdgeId e : {d.corner, front_[d.corner].previous}) {
        const auto apex = near_.delaunay_apex(e);
        if (!apex) continue;
        const VertexId v = front_[*apex].origin;
        const bool across = guide_.spheres.containing(mesh_.at(v)) == saddle &&
                            side_of_saddle(saddle, v) != static_cast<int>(side);
        if (!across) continue;
        fresh_.assign({front_[e].next});
        attach(e, *apex);
        ++operations_.bridge;
        note(Operation::Bridge);
        wing();
        is_bridged = true;
        break;
      }
      // [/excerpt]
    }
    marked.sides[side].clear();
  }
}

/// Closes the hole round a maximum with triangles over neighbouring edges; those that are too big
/// are left to the refinement, as in section 4.3.
void Sweep::seal(CriticalId maximum) {
  Marked& marked = marked_[maximum.index()];
  if (guide_.points[maximum.index()].index != 2) return;
  marked.is_done = true;
  bool is_sealed = false;
  for (const Departure& d : std::exchange(marked.sides[0], {})) {
    // [excerpt: seal]
    while (is_current(d)) {
      look_round(d.corner);
      const auto apex = last_apex(d.corner);
      if (!apex) {
        stuck_.push_back(d);
        break;
      }
      attach(d.corner, *apex);
      is_sealed = true;
    }
    // [/excerpt]
  }
  if (!is_sealed) return;
  ++operations_.seal;
  note(Operation::Seal);
}

}  // namespace morskin::front
