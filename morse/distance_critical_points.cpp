#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/orthogonal.h"
#include "morse/cell_contact.h"
#include "morse/critical_points_internal.h"
#include "morse/distance_equation.h"

namespace morskin::morse {

namespace {

using skin::CellId;
using skin::Patch;

/// A patch relative to the origin p of the distance.
struct View {
  const skin::SkinSurface& surface;
  const MorseFunction& function;
  CellId cell;
  Patch patch;
  Vector out;            ///< unit, from the axis (of a sphere: from the centre) to p; or zero
  double across, along;  ///< p - centre along `out` and along the axis
  double rounding;       ///< error of p - centre, Angstrom
};

View view(const skin::SkinSurface& surface, const MorseFunction& function, CellId cell,
          const Point& origin) {
  const Patch& patch = surface.complex().patch(cell);
  const Vector d = origin - patch.centre;
  double along = patch.axis.dot(d);
  Vector across = d - along * patch.axis;
  // The centre has a relative error of 2^-53, or of that in the atoms' coordinates where it is
  // their sum; its difference with p, the unit axis and products with it add less than 2^-50 |d|.
  const double rounding = std::ldexp(d.norm() + patch.centre.norm(), -50) +
                          std::ldexp(surface.complex().wall_tolerance(), -8);
  if (across.norm() <= rounding) across.setZero();
  if (std::abs(along) <= rounding) along = 0;
  const Vector out = across.isZero(0) ? across : geometry::unit_orthogonal_part(across, patch.axis);
  return {surface, function, cell, patch, out, across.norm(), along, rounding};
}

/// Half the Hessian on the tangent plane is I - mu M: 1 - m across the axis, and along the meridian
///     1 - m + 2 m |a|^2 = ((1 + m) |u_across|^2 + (1 - m) u_along^2) / |u|^2,
/// a the axis's part in that plane.
double meridian_eigenvalue(const MeridianPoint& p) {
  const double across = p.across * p.across, along = p.along * p.along;
  return (p.one_plus_m * across + p.one_minus_m * along) / (across + along);
}

CriticalPoint classify(const View& v, const MeridianPoint& p) {
  const Vector u = p.across * v.out + p.along * v.patch.axis;
  CriticalPoint critical;
  const Point x = v.patch.centre + u;
  const double rho = u.norm();
  critical.point = {x, v.patch.reflect(u) / rho, rho, v.cell};
  critical.value = v.function(x);
  const double meridian = v.patch.axis.isZero() ? p.one_minus_m : meridian_eigenvalue(p);
  critical.index = (p.one_minus_m < 0) + (meridian < 0);
  if (critical.index == 1) {
    critical.descending = (p.along * v.out + p.across * v.patch.axis).normalized();
    critical.ascending = v.patch.axis.cross(v.out).normalized();
    if (meridian > 0) std::swap(critical.descending, critical.ascending);
  }
  return critical;
}

void add_sphere(const View& v, CriticalPoints& result) {
  const double square = v.patch.sign * v.patch.half_weight;
  if (!(square > 0)) return;
  const double radius = std::sqrt(square);
  const double doubt = wall_doubt * radius + v.surface.complex().wall_tolerance();
  if (v.across == 0) {
    const auto point = point_in_cell(v.surface.complex(), v.cell, v.patch.centre, radius, doubt);
    if (point) {
      result.degeneracies.push_back("a patch of critical points, a sphere about the origin, " +
                                    position_text(*point));
    }
    return;
  }
  for (const double m_side : {1.0, -1.0}) {
    const double one_minus_m = m_side * v.across / radius;
    const CriticalPoint critical =
        classify(v, {one_minus_m, 2 - one_minus_m, m_side * radius, 0, false});
    take(v.surface, critical, doubt + v.rounding / std::abs(one_minus_m), result);
  }
}

/// Bound on the rounding of a critical point along the meridian, Angstrom.
///
/// With t the arc length, an error e of p turns f'/2 = 0 into lambda t + c t^2 / 2 + .. = e, lambda
/// the eigenvalue, so t < 2 e / |lambda| if the root is isolated. If it is not, the worst case is p
/// at the meridian's centre of curvature at its tip, the cusp of the evolute, where
/// t^3 / rho^2 = e; the bound is three times that t.
double meridian_doubt(double lambda, double rho, double error) {
  return std::min(2 * error / std::abs(lambda), 3 * std::cbrt(error * rho * rho));
}

void add_hyperboloid(const View& v, CriticalPoints& result) {
  const skin::MixedComplex& complex = v.surface.complex();
  const double W = v.patch.sign * v.patch.half_weight;
  for (const MeridianPoint& p : distance_equation(v.across, v.along, W, v.rounding)) {
    const double rho = std::hypot(p.across, p.along);
    const double wall = wall_doubt * rho + complex.wall_tolerance();
    if (p.is_circle) {
      const Circle circle{v.patch.centre + p.along * v.patch.axis, v.patch.axis, p.across};
      const auto point = point_in_cell(complex, v.cell, circle, wall);
      if (point) {
        result.degeneracies.push_back("a circle of critical points about an axis through the " +
                                      ("origin, " + position_text(*point)));
      }
      continue;
    }
    const double lambda = meridian_eigenvalue(p);
    // Off the axis an error of p across the meridian turns the point about the axis.
    const double turn =
        v.across > 0 ? std::abs(p.across) * std::min(1.0, v.rounding / v.across) : 0;
    const double doubt = wall + turn + meridian_doubt(lambda, rho, v.rounding);
    if (!take(v.surface, classify(v, p), doubt, result)) continue;
    // The root is isolated while lambda^2 > 2 |c| e. With |p - x| = |m| rho and the curvature's
    // change along the meridian at most 3 / rho^2, |c| <= 3 |m| / rho.
    const double m = std::abs(p.one_plus_m - p.one_minus_m) / 2;
    if (lambda * lambda * rho <= 6 * m * v.rounding) {
      result.degeneracies.push_back("the Hessian is singular within rounding at a critical point " +
                                    position_text(result.points.back().point.position));
    }
  }
}

}  // namespace

void add_distance_critical_points(const skin::SkinSurface& surface, CellId cell,
                                  const MorseFunction& function, const Point& origin,
                                  CriticalPoints& result) {
  const View v = view(surface, function, cell, origin);
  v.patch.axis.isZero() ? add_sphere(v, result) : add_hyperboloid(v, result);
}

}  // namespace morskin::morse
