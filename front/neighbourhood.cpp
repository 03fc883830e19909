#include "front/neighbourhood.h"

#include <algorithm>
#include <cmath>

namespace morskin::front {

void Neighbourhood::move_to(const SurfacePoint& centre) {
  origin_ = centre.position;
  normal_ = centre.normal;
  tangent_ = geometry::TangentFrame(normal_);
  corners_.clear();
  if (index_.size() < front_.capacity()) index_.resize(2 * front_.capacity(), 0);
  radius_ = front_.grid().max_radius(centre.length_scale);
}

void Neighbourhood::gather(const SurfacePoint& centre) {
  move_to(centre);
  front_.grid().for_each_within(origin_, centre.length_scale, radius_, [&](FrontEdgeId e) {
    if (is_within_radius(e)) add(e);
  });
  // Edges that come in from a vertex outside.
  const std::size_t within = corners_.size();
  for (std::size_t i = 0; i < within; ++i) add(front_[corners_[i].edge].previous);
}

/// Notes an edge, once.
void Neighbourhood::add(FrontEdgeId e) {
  std::uint32_t& index = index_[e];
  if (index < corners_.size() && corners_[index].edge == e) return;
  index = static_cast<std::uint32_t>(corners_.size());
  update(e, corners_.emplace_back());
}

void Neighbourhood::update(FrontEdgeId e, Corner& corner) const {
  const FrontEdge &edge = front_[e], &next = front_.next(e);
  corner.edge = e;
  corner.vertex = edge.origin;
  corner.target = next.origin;
  corner.is_open = true;
  corner.at = local(edge.position);
  corner.to = plane(next);
}

void Neighbourhood::follow(const FrontChange& change) {
  for (const FrontEdgeId e : change.closed) forget(e);
  for (const FrontEdgeId e : change.moved) refresh(e);
  for (const FrontEdgeId e : change.opened) refresh(e);
}

/// Notes that a front edge is new or has new ends.
void Neighbourhood::refresh(FrontEdgeId e) {
  if (index_.size() <= e.index()) index_.resize(2 * front_.capacity(), 0);
  const std::uint32_t index = index_[e];
  if (index < corners_.size() && corners_[index].edge == e) {
    update(e, corners_[index]);
  } else {
    add(e);
  }
}

/// Drops an edge that is no longer open.
void Neighbourhood::forget(FrontEdgeId e) {
  if (index_.size() <= e.index()) return;
  const std::uint32_t index = index_[e];
  if (index < corners_.size() && corners_[index].edge == e) corners_[index].is_open = false;
}

bool Neighbourhood::is_bare_within(double distance) const {
  const double within = std::min(distance, radius_);
  return std::ranges::none_of(corners_, [&](const Corner& c) {
    return (front_[c.edge].position - origin_).squaredNorm() <= within * within;
  });
}

double Neighbourhood::bare_angle(FrontEdgeId corner) const {
  const Vector2 at = plane(front_[corner]);
  const Vector2 out = plane(front_.next(corner)) - at, in = plane(front_.previous(corner)) - at;
  // A finished fan at a vertex never spans less than this, radians.
  constexpr double min_fan_angle = 0.3;
  double angle = std::atan2(cross(in, out), in.dot(out));
  if (angle < 0) angle += 2 * M_PI;
  return angle > 2 * M_PI - min_fan_angle ? 0 : angle;
}

bool Neighbourhood::is_acute(FrontEdgeId corner, double cosine) const {
  const Vector2 at = plane(front_[corner]);
  const Vector2 out = plane(front_.next(corner)) - at, in = plane(front_.previous(corner)) - at;
  const double along = in.dot(out);
  if (along <= 0 || along * along < cosine * cosine * in.squaredNorm() * out.squaredNorm()) {
    return false;
  }
  constexpr double min_fan_tangent = 0.3;  // about that of min_fan_angle in bare_angle()
  return cross(in, out) > -min_fan_tangent * along;
}

}  // namespace morskin::front
