#include "refine/triangle_geometry.h"

#include "skin/level_set.h"

namespace morskin::refine {

namespace {

/// How far along `line` from x the patch's function vanishes, by one Newton step, in units of the
/// line's length; nothing where that is farther than `reach`, Angstrom.
std::optional<double> newton_step(const skin::Patch& patch, const Point& x, const Vector& line,
                                  double reach) {
  const Vector n = patch.half_gradient(x);
  const double g = (x - patch.centre).dot(n) - patch.half_weight;
  const double slope = 2 * n.dot(line);
  if (g * g * line.squaredNorm() >= slope * slope * reach * reach) return std::nullopt;
  return -g / slope;
}

SurfaceBall ball_about(const Point& centre, const SurfacePoint& a, bool is_exact) {
  return {centre, (centre - a.position).squaredNorm(), is_exact};
}

}  // namespace

template <class Surface>
SurfaceBall quick_surface_ball(const Surface& skin, const SurfacePoint& a,
                               const Circumcircle& circle) {
  const auto step = skin.with_patch(a.cell, [&](const skin::Patch& patch) {
    return newton_step(patch, circle.centre, circle.doubled_area, circle.radius);
  });
  return ball_about(circle.centre + step.value_or(0) * circle.doubled_area, a, false);
}

template <class Surface>
SurfaceBall exact_surface_ball(const Surface& skin, const SurfacePoint& a, const Point& b,
                               const Point& c) {
  const Circumcircle circle = circumcircle(a.position, b, c);
  constexpr int most_steps = 12;
  Point x = circle.centre;
  skin::CellId cell = a.cell;
  bool is_on_skin = false;
  for (int i = 0; i < most_steps; ++i) {
    cell = skin.locate(x, cell);
    const skin::Patch& patch = skin.patch(cell);
    const double rho = patch.length_scale(x);
    is_on_skin = std::abs(patch.value(x)) <= skin.residual_bound(rho);
    if (is_on_skin) break;
    const auto step = newton_step(patch, x, circle.doubled_area, circle.radius);
    if (!step) break;
    x += *step * circle.doubled_area;
  }
  return ball_about(x, a, is_on_skin);
}

template SurfaceBall quick_surface_ball(const skin::SkinSurface&, const SurfacePoint&,
                                        const Circumcircle&);
template SurfaceBall quick_surface_ball(const skin::LevelSet&, const SurfacePoint&,
                                        const Circumcircle&);
template SurfaceBall exact_surface_ball(const skin::SkinSurface&, const SurfacePoint&, const Point&,
                                        const Point&);
template SurfaceBall exact_surface_ball(const skin::LevelSet&, const SurfacePoint&, const Point&,
                                        const Point&);

}  // namespace morskin::refine
