#include "certify/ball_pencil.h"

namespace morskin::certify {

std::optional<BallPencil> ball_pencil(const surface::Surface& surface,
                                      const std::array<const SurfacePoint*, 3>& corners,
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
  const double most = g + (2 * tilt + R) * R;
  const double m = rho * upright - R;
  if (!(m > 0) || !(m * m > most)) return std::nullopt;
  result.reach = most / (m + std::sqrt(m * m - most));
  return result;
}

const std::optional<BallPencil>& QuestionedBall::pencil() {
  if (!has_looked_) pencil_ = ball_pencil(surface_, corners_, circle_);
  has_looked_ = true;
  return pencil_;
}

Depth QuestionedBall::depth(const Point& p) {
  return pencil() ? pencil()->depth(p) : exact_depth(p);
}

/// When the bounds do not tell, the ball is found to rounding, and when it is hardly entered it
/// counts as empty.
Depth QuestionedBall::nearer_intrusion(const Point& p) {
  if (pencil()) {
    const Depth bounds = pencil()->depth(p);
    const double most_squared_radius =
        circle_.radius * circle_.radius + pencil()->reach * pencil()->reach;
    if (bounds.most <= 0 || bounds.least > least_intrusion * most_squared_radius) return bounds;
  }
  const SurfaceBall ball = exact_ball();
  const double depth = ball.intrusion(p);
  if (depth > 0 && depth <= least_intrusion * ball.squared_radius) return outside;
  return {depth, depth};
}

}  // namespace morskin::certify
