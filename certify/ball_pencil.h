#pragma once

/// Bounds on a triangle's surface ball without its centre. The balls through the three corners form
/// a pencil, with centres x = o + s n on the line through the circumcentre o along the unit normal
/// n. A bound on s mostly decides on which side of the surface ball a vertex lies; only where it
/// does not is the ball computed.

#include <limits>
#include <optional>

#include "certify/triangle_geometry.h"

namespace morskin::certify {

/// A vertex enters a ball if it is deeper in it than this share of the squared radius: above
/// rounding, so that vertices on one circle settle either way.
inline constexpr double min_intrusion = 1e-9;

/// Bounds on the depth of a point in a ball, squared radius less squared distance, Angstrom^2.
struct Depth {
  double min, max;
};

struct BallPencil {
  Circumcircle circle;
  Vector normal;                  ///< unit
  double min_offset, max_offset;  ///< bounds on s of the surface ball, Angstrom

  /// Bounds on the depth of p in the surface ball. At height h over the triangle's plane it is
  ///
  ///     (squared radius) - |p - x|^2 = R^2 - |p - o|^2 + 2 s h,
  ///
  /// linear in s.
  Depth depth(const Point& p) const {
    const Vector d = p - circle.centre;
    const double middle = circle.radius * circle.radius - d.squaredNorm();
    const double low = 2 * min_offset * d.dot(normal), high = 2 * max_offset * d.dot(normal);
    return {middle + std::min(low, high), middle + std::max(low, high)};
  }
  /// Bound on the squared radius of the surface ball, Angstrom^2.
  double max_squared_radius() const {
    const double most = std::max(-min_offset, max_offset);
    return circle.radius * circle.radius + most * most;
  }
};

/// The bound on s: with N = grad G / 2, which is 1-Lipschitz, and a corner a with |G(a)| = g,
///
///     |G(o)| <= g + 2 |N(a).(o - a)| + R^2 <= g + 2 t R + R^2,     t^2 = |N(a)|^2 - (N(a).n)^2,
///     N(o).n >= N(a).n - R =: m,      |G(o + s n) - G(o) - 2 s N(o).n| <= s^2,
///
/// so G changes its sign on |s| <= m - sqrt(m^2 - |G(o)|) if m^2 > |G(o)|, and only once, since
/// N.n > 0 for |s| < m. The corner whose normal is nearest to n gives the best bound.
/// @return nothing where m^2 <= |G(o)|
std::optional<BallPencil> ball_pencil(const surface::Surface& surface, const Corners& corners,
                                      const Circumcircle& circle);
/// The same from N and G at o itself, for a walk there: narrow, and with the sign of s, that of
/// -G(o). By the same token |G(o)| <= 2 m |s| + s^2, which bounds |s| from below.
std::optional<BallPencil> ball_pencil_by_centre(const surface::Surface& surface,
                                                const Corners& corners, const Circumcircle& circle);

/// Bound on |s| / R of a close ball. ball_pencil() implies it where, at a corner a, R is at most
/// 0.15 rho and the cosine between the skin's normal and the triangle's at least 0.97.
inline constexpr double close_offset = 0.403;
inline bool is_ball_close(const SurfacePoint& a, const Circumcircle& circle) {
  const double upright = a.normal.dot(circle.doubled_area);
  return circle.radius <= 0.15 * a.length_scale && upright > 0 &&
         upright * upright >= 0.97 * 0.97 * circle.doubled_area.squaredNorm();
}

/// A triangle's surface ball, computed only as exactly as each question needs.
class LazySurfaceBall {
 public:
  LazySurfaceBall(const surface::Surface& surface, const Corners& corners,
                  const Circumcircle& circle)
      : surface_(surface),
        corners_(corners),
        circle_(circle),
        is_close_(is_ball_close(*corners[0], circle)) {}

  /// Bounds on the depth of p that decide whether p enters the ball.
  Depth intrusion(const Point& p) {
    return is_close_ && is_outside_close_ball(p) ? outside : refined_intrusion(p);
  }
  /// The pencil's bounds, or exact ones where it has none.
  Depth depth(const Point& p);
  /// Exact to rounding: min equals max.
  Depth exact_depth(const Point& p) const {
    const double depth = exact_ball().intrusion(p);
    return {depth, depth};
  }

 private:
  static constexpr Depth outside{-std::numeric_limits<double>::infinity(), 0};
  /// BallPencil::depth() with close_offset, without square roots.
  bool is_outside_close_ball(const Point& p) const {
    const Vector d = p - circle_.centre;
    const double beyond = d.squaredNorm() - circle_.radius * circle_.radius;
    const double lifted = 2 * close_offset * circle_.radius * d.dot(circle_.doubled_area);
    return beyond > 0 && beyond * beyond * circle_.doubled_area.squaredNorm() > lifted * lifted;
  }
  Depth refined_intrusion(const Point& p);
  SurfaceBall exact_ball() const {
    return exact_surface_ball(surface_, *corners_[0], corners_[1]->position, corners_[2]->position);
  }
  const std::optional<BallPencil>& pencil();
  /// Whether the pencil's bounds tell on which side of the ball p is.
  static bool decides(const std::optional<BallPencil>& pencil, const Point& p);

  const surface::Surface& surface_;
  const Corners corners_;
  const Circumcircle circle_;
  const bool is_close_;
  bool has_pencil_ = false;  ///< whether pencil_ has been computed
  std::optional<BallPencil> pencil_;
};

}  // namespace morskin::certify
