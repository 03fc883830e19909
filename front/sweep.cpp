#include "front/sweep.h"

#include <initializer_list>
#include <utility>

namespace morskin::front {

Sweep::Sweep(const surface::Surface& surface, const morse::Guide& guide,
             const SweepOptions& options, Mesh& mesh, std::vector<SweepObserver*> observers)
    : guide_(guide),
      disk_(surface, options.sizing, options.spacing),
      mesh_(mesh),
      front_(mesh, disk_.view_share(), options.sizing.largest_length_scale),
      policy_(*options.guard),
      guard_(mesh, front_),
      departures_(front_, guide.function),
      marks_(guide.points),
      coverage_(surface, disk_),
      observers_(std::move(observers)) {
  if (options.record_births) mesh_.births.emplace(mesh_.surface);
  for (FrontMirror* mirror :
       std::initializer_list<FrontMirror*>{&guard_, &departures_, &fresh_, &coverage_}) {
    front_.add_mirror(*mirror);
  }
  for (SweepObserver* observer : observers_) front_.add_mirror(*observer);
}

IdOffsets Sweep::absorb(Sweep& other) {
  const IdOffsets offsets{
      .vertices = static_cast<std::uint32_t>(mesh_.surface.vertex_count()),
      .half_edges = static_cast<std::uint32_t>(3 * mesh_.surface.triangle_count()),
      .edges = static_cast<std::uint32_t>(front_.capacity())};
  mesh_.surface.append(std::move(other.mesh_.surface));
  front_.absorb(other.front_, offsets);
  departures_.absorb(other.departures_, offsets.edges);
  marks_.absorb(other.marks_);
  coverage_.absorb(other.coverage_);
  return offsets;
}

/// The lowest departure of the queue that is current and within the region.
std::optional<Departure> Sweep::lowest_departure() {
  while (!departures_.empty() && !coverage_.is_overlapping()) {
    for (SweepObserver* observer : observers_) observer->between_departures(front_);
    const Departure t = departures_.extract_min();
    if (!departures_.is_current(t)) continue;
    for (SweepObserver* observer : observers_) observer->departed(t, front_);
    if (may_depart(t)) return t;
    departures_.postpone(t);
  }
  return std::nullopt;
}

/// Whether all that could be laid at the departure vertex stays within the region.
bool Sweep::may_depart(const Departure& t) const {
  const SurfacePoint& p = mesh_.at(front_[t.corner].origin);
  return region_.contains(p.position, disk_.working_radius(p));
}

/// The protecting sphere that a departure vertex lies in, if it has not been released.
std::optional<CriticalId> Sweep::protecting_sphere(const Departure& t) const {
  const auto c = guide_.spheres.containing(mesh_.at(front_[t.corner].origin));
  return c && !marks_.is_released(*c) ? c : std::nullopt;
}

bool Sweep::is_saddle(std::optional<CriticalId> c) const {
  return c && guide_.points[c->index()].index == 1;
}

bool Sweep::is_maximum(std::optional<CriticalId> c) const {
  return c && guide_.points[c->index()].index == 2;
}

void Sweep::mark_red(CriticalId saddle, const Departure& t) {
  marks_.mark(saddle, side_of_saddle(saddle, front_[t.corner].origin), t);
  for (SweepObserver* observer : observers_) observer->marked(saddle, t);
}

void Sweep::mark_green(CriticalId maximum, const Departure& t) {
  marks_.mark(maximum, 0, t);
  for (SweepObserver* observer : observers_) observer->marked(maximum, t);
}

/// A front comes up to a saddle from two sides, by both of its lines of steepest descent.
std::size_t Sweep::side_of_saddle(CriticalId saddle, VertexId v) const {
  const morse::CriticalPoint& s = guide_.points[saddle.index()];
  return s.descending.dot(mesh_.position(v) - s.point.position) > 0 ? 1 : 0;
}

/// Whether the front can have come to a maximum from all sides. Where part of its protecting sphere
/// is out of the region, the departures there wait for a larger one: what is left about it is no
/// hole, and triangles over existing vertices would be far too long.
bool Sweep::is_surrounded(CriticalId maximum) {
  const SurfacePoint& p = guide_.points[maximum.index()].point;
  const double radius = guide_.spheres.radius(maximum) + disk_.working_radius(p);
  if (region_.contains(p.position, radius)) return true;
  const Marks::Sides green = marks_.release(maximum);
  for (const Departure& t : green[0]) departures_.postpone(t);
  return false;
}

/// Gathers the front about a corner for the guard.
void Sweep::inspect(FrontEdgeId corner) {
  policy_.gather(guard_, mesh_.at(front_[corner].origin), corner);
}

/// The circle through a corner and its two neighbours.
certify::Circumcircle Sweep::ear(FrontEdgeId corner) const {
  return certify::circumcircle(front_[corner].position, front_.previous(corner).position,
                               front_.next(corner).position);
}

bool Sweep::is_ear_small(FrontEdgeId corner) const {
  return disk_.is_ear_small(ear(corner), mesh_.at(front_[corner].origin));
}

void Sweep::done(Operation operation) const {
  for (SweepObserver* observer : observers_) observer->operation_done(operation, front_);
}

/// A saddle reached from one side only, both branches having met elsewhere, stops the front no
/// longer (E18).
void Sweep::release_red_marks() {
  for (const CriticalId saddle : marks_.release_all(Marks::saddle)) {
    for (const auto& side : marks_.release(saddle)) departures_.put_back(side);
  }
}

/// The existing vertex to finish edge e with. Three edges are a triangle, however flat: the flips
/// of the refinement mend its shape.
std::optional<FrontEdgeId> Sweep::last_apex(FrontEdgeId e) const {
  return front_.is_triangle(e) ? front_[e].previous : guard_.delaunay_apex(e);
}

}  // namespace morskin::front
