#include "refine/ball_pencil.h"

namespace morskin::refine {

std::optional<BallPencil> ball_pencil(const skin::SkinSurface& skin,
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
  const double g = skin.with_patch(
      a->cell, [&](const skin::Patch& patch) { return std::abs(patch.value(a->position)); });
  const double tilt = rho * std::sqrt(std::max(0.0, 1 - upright * upright));
  const double most = g + (2 * tilt + R) * R;
  const double m = rho * upright - R;
  if (!(m > 0) || !(m * m > most)) return std::nullopt;
  result.reach = most / (m + std::sqrt(m * m - most));
  return result;
}

}  // namespace morskin::refine
