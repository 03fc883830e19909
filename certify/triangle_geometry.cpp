#include "certify/triangle_geometry.h"

namespace morskin::certify {

namespace {

/// How far along `line` from x the function of `jet` vanishes, by one Newton step, in units of the
/// line's length; nothing where that is farther than `max_distance`, Angstrom.
std::optional<double> newton_step(const surface::Jet& jet, const Vector& line,
                                  double max_distance) {
  const double g = jet.value;
  const double slope = 2 * jet.half_gradient.dot(line);
  if (g * g * line.squaredNorm() >= slope * slope * max_distance * max_distance) {
    return std::nullopt;
  }
  return -g / slope;
}

SurfaceBall ball_about(const Point& centre, const SurfacePoint& a, bool is_exact) {
  return {centre, (centre - a.position).squaredNorm(), is_exact};
}

}  // namespace

SurfaceBall quick_surface_ball(const surface::Surface& surface, const SurfacePoint& a,
                               const Circumcircle& circle) {
  const auto step =
      newton_step(surface.jet(circle.centre, a.cell), circle.doubled_area, circle.radius);
  return ball_about(circle.centre + step.value_or(0) * circle.doubled_area, a, false);
}

SurfaceBall exact_surface_ball(const surface::Surface& surface, const SurfacePoint& a,
                               const Point& b, const Point& c) {
  const Circumcircle circle = circumcircle(a.position, b, c);
  constexpr int max_steps = 12;
  Point x = circle.centre;
  surface::CellId cell = a.cell;
  bool is_on_surface = false;
  for (int i = 0; i < max_steps; ++i) {
    cell = surface.locate(x, cell);
    const surface::Jet jet = surface.jet(x, cell);
    const double rho = surface.length_scale(x, cell);
    is_on_surface = std::abs(jet.value) <= surface.residual_bound(rho);
    if (is_on_surface) break;
    const auto step = newton_step(jet, circle.doubled_area, circle.radius);
    if (!step) break;
    x += *step * circle.doubled_area;
  }
  return ball_about(x, a, is_on_surface);
}

}  // namespace morskin::certify
