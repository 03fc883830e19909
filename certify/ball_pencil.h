#pragma once

/// What is known of a triangle's surface ball without looking for its centre. All balls through the
/// three corners are a pencil, with their centres on the line x = o + s n through the circumcentre
/// o along the unit normal n. A bound on s mostly tells already on which side of the surface ball a
/// vertex lies; the ball itself is found only where it does not.

#include <array>
#include <limits>
#include <optional>

#include "certify/triangle_geometry.h"

namespace morskin::certify {

/// A ball counts as entered when a vertex is deeper in it than this share of its squared radius:
/// above rounding, so that vertices on one circle settle either way.
inline constexpr double least_intrusion = 1e-9;

/// How deep a point lies in a ball, squared radius less squared distance, Angstrom^2: at least and
/// at most.
struct Depth {
  double least, most;
};

struct BallPencil {
  Circumcircle circle;
  Vector normal;  ///< unit
  double reach;   ///< Angstrom: the surface ball has |s| <= reach

  /// How deep p lies in the surface ball. At height h over the triangle's plane that is
  ///
  ///     (squared radius) - |p - x|^2 = R^2 - |p - o|^2 + 2 s h,
  ///
  /// linear in s.
  Depth depth(const Point& p) const {
    const Vector d = p - circle.centre;
    const double middle = circle.radius * circle.radius - d.squaredNorm();
    const double spread = 2 * reach * std::abs(d.dot(normal));
    return {middle - spread, middle + spread};
  }
};

/// The bound on s: with N = grad G / 2, which is 1-Lipschitz, and a corner a on the skin to within
/// |G(a)| = g:
///
///     |G(o)| <= g + 2 |N(a).(o - a)| + R^2 <= g + 2 t R + R^2,     t^2 = |N(a)|^2 - (N(a).n)^2,
///     N(o).n >= N(a).n - R =: m,      |G(o + s n) - G(o) - 2 s N(o).n| <= s^2,
///
/// so G changes its sign on |s| <= m - sqrt(m^2 - |G(o)|) if m^2 > |G(o)|, and once, since N.n > 0
/// as long as |s| < m. The corner whose normal is nearest to n gives the best bound.
/// @return nothing where the bound does not hold.
std::optional<BallPencil> ball_pencil(const surface::Surface& surface,
                                      const std::array<const SurfacePoint*, 3>& corners,
                                      const Circumcircle& circle);

/// Whether the surface ball's centre surely lies within close_reach of the circumcentre, in shares
/// of R. The bound above tells so where R is at most 0.15 of the length scale at a corner a and the
/// cosine between the normal there and the triangle's at least 0.97.
inline bool is_ball_close(const SurfacePoint& a, const Circumcircle& circle) {
  const double upright = a.normal.dot(circle.doubled_area);
  return circle.radius <= 0.15 * a.length_scale && upright > 0 &&
         upright * upright >= 0.97 * 0.97 * circle.doubled_area.squaredNorm();
}
inline constexpr double close_reach = 0.403;

/// A triangle's surface ball, found as exactly as the questions about it take.
class QuestionedBall {
 public:
  QuestionedBall(const surface::Surface& surface, const std::array<const SurfacePoint*, 3>& corners,
                 const Circumcircle& circle)
      : surface_(surface),
        corners_(corners),
        circle_(circle),
        is_close_(is_ball_close(*corners[0], circle)) {}

  /// How deep p lies in the ball, between bounds that tell whether it lies inside.
  Depth intrusion(const Point& p) {
    return is_close_ && is_outside_close_ball(p) ? outside : nearer_intrusion(p);
  }
  /// The same between any bounds that there are.
  Depth depth(const Point& p);
  /// The same with the ball found to rounding.
  Depth exact_depth(const Point& p) const {
    const double depth = exact_ball().intrusion(p);
    return {depth, depth};
  }

 private:
  static constexpr Depth outside{-std::numeric_limits<double>::infinity(), 0};
  /// With that bound on s, as BallPencil::depth(), but for square roots.
  bool is_outside_close_ball(const Point& p) const {
    const Vector d = p - circle_.centre;
    const double beyond = d.squaredNorm() - circle_.radius * circle_.radius;
    const double lifted = 2 * close_reach * circle_.radius * d.dot(circle_.doubled_area);
    return beyond > 0 && beyond * beyond * circle_.doubled_area.squaredNorm() > lifted * lifted;
  }
  Depth nearer_intrusion(const Point& p);
  SurfaceBall exact_ball() const {
    return exact_surface_ball(surface_, *corners_[0], corners_[1]->position, corners_[2]->position);
  }
  const std::optional<BallPencil>& pencil();

  const surface::Surface& surface_;
  const std::array<const SurfacePoint*, 3> corners_;
  const Circumcircle circle_;
  const bool is_close_;
  bool has_looked_ = false;  ///< for the pencil
  std::optional<BallPencil> pencil_;
};

}  // namespace morskin::certify
