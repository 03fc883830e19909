#include "certify/ball_pencil.h"

namespace morskin::certify {

std::optional<BallPencil> ball_pencil(const surface::Surface& surface, const Corners& corners,
                                      const Circumcircle& circle) {
  BallPencil result{circle, circle.doubled_area / circle.doubled_area.norm(), 0, 0};
  const double R = circle.radius;
  const SurfacePoint* a = corners[0];
  double upright = -1;
  for (const SurfacePoint* p : corners) {
    const double cosine = p->normal.dot(result.normal);
    if (!(cosine > upright)) continue;
    upright = cosine;
    a = p;
  }
  const double rho = a->length_scale;
  const double g = std::abs(surface.jet(a->position, a->cell).value);
  const double tilt = rho * std::sqrt(std::max(0.0, 1 - upright * upright));
  const double max_G = g + (2 * tilt + R) * R;
  const double m = rho * upright - R;
  if (!(m > 0) || !(m * m > max_G)) return std::nullopt;
  result.max_offset = max_G / (m + std::sqrt(m * m - max_G));
  result.min_offset = -result.max_offset;
  return result;
}

std::optional<BallPencil> ball_pencil_by_centre(const surface::Surface& surface,
                                                const Corners& corners,
                                                const Circumcircle& circle) {
  const Vector normal = circle.doubled_area / circle.doubled_area.norm();
  const auto& [value, N] =
      surface.jet(circle.centre, surface.locate(circle.centre, corners[0]->cell));
  const double g = std::abs(value), m = N.dot(normal);
  if (!(m > 0) || !(m * m > g)) return std::nullopt;
  const double least = g / (m + std::sqrt(m * m + g)), most = g / (m + std::sqrt(m * m - g));
  return value > 0 ? BallPencil{circle, normal, -most, -least}
                   : BallPencil{circle, normal, least, most};
}

const std::optional<BallPencil>& LazySurfaceBall::pencil() {
  if (!has_pencil_) pencil_ = ball_pencil(surface_, corners_, circle_);
  has_pencil_ = true;
  return pencil_;
}

Depth LazySurfaceBall::depth(const Point& p) {
  return pencil() ? pencil()->depth(p) : exact_depth(p);
}

bool LazySurfaceBall::decides(const std::optional<BallPencil>& pencil, const Point& p) {
  if (!pencil) return false;
  const Depth bounds = pencil->depth(p);
  return bounds.max <= 0 || bounds.min > min_intrusion * pencil->max_squared_radius();
}

/// Where no bounds decide, computes the ball; hardly entered, it counts as empty.
Depth LazySurfaceBall::refined_intrusion(const Point& p) {
  if (decides(pencil(), p)) return pencil_->depth(p);
  pencil_ = ball_pencil_by_centre(surface_, corners_, circle_);
  if (decides(pencil_, p)) return pencil_->depth(p);
  const SurfaceBall ball = exact_ball();
  const double depth = ball.intrusion(p);
  if (depth > 0 && depth <= min_intrusion * ball.squared_radius) return outside;
  return {depth, depth};
}

}  // namespace morskin::certify
