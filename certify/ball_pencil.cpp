#include "certify/ball_pencil.h"

namespace morskin::certify {

std::optional<BallPencil> ball_pencil(const surface::Surface& surface, const Corners& corners,
                                      const Circumcircle& circle) {
  BallPencil result{circle, circle.doubled_area / circle.doubled_area.norm(), 0};
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
  return result;
}

const std::optional<BallPencil>& LazySurfaceBall::pencil() {
  if (!has_pencil_) pencil_ = ball_pencil(surface_, corners_, circle_);
  has_pencil_ = true;
  return pencil_;
}

Depth LazySurfaceBall::depth(const Point& p) {
  return pencil() ? pencil()->depth(p) : exact_depth(p);
}

/// Where the bounds do not decide, computes the ball; hardly entered, it counts as empty.
Depth LazySurfaceBall::refined_intrusion(const Point& p) {
  if (pencil()) {
    const Depth bounds = pencil()->depth(p);
    const double max_squared_radius =
        circle_.radius * circle_.radius + pencil()->max_offset * pencil()->max_offset;
    if (bounds.max <= 0 || bounds.min > min_intrusion * max_squared_radius) return bounds;
  }
  const SurfaceBall ball = exact_ball();
  const double depth = ball.intrusion(p);
  if (depth > 0 && depth <= min_intrusion * ball.squared_radius) return outside;
  return {depth, depth};
}

}  // namespace morskin::certify
