#pragma once

/// What critical points of heights and of squared distances have in common.

#include <Eigen/Dense>

#include "morse/critical_points.h"
#include "tests/support/test.h"

namespace morskin::support {

/// What rounding leaves of a length at a critical point: the rounding of coordinates this large,
/// and a share of the length scale.
inline double rounding_at(const skin::SkinSurface& skin, const morse::CriticalPoint& p) {
  return 1e-10 * p.point.length_scale + skin.complex().wall_tolerance();
}

/// The point lies on the skin, with the normal and the length scale that the skin has there.
inline void check_on_skin(const skin::SkinSurface& skin, const morse::CriticalPoint& p) {
  const surface::SurfacePoint& x = p.point;
  const double rho = x.length_scale, off = rounding_at(skin, p);
  const geometry::CellId cell = skin.locate(x.position, x.cell);
  CHECK(std::abs(skin.complex().patch(cell).value(x.position)) <= 2 * rho * off);
  const surface::SurfacePoint there = skin.at(x.position, cell);
  CHECK((there.normal - x.normal).norm() <= 4 * off / rho);
  CHECK(std::abs(there.length_scale - rho) <= 4 * off);
}

/// The point of one patch's quadric nearest to x in the sense of project(), cells left out.
inline geometry::Point on_patch(const skin::Patch& patch, geometry::Point x) {
  for (int round = 0; round < 20; ++round) x = patch.slide(x);
  return x;
}

/// Eigenvalues, ascending, of the Hessian by differences of rise(step), the change of the function
/// over a step in the tangent plane.
template <class Rise>
Eigen::Vector2d hessian_values(const geometry::Vector& normal, Rise rise) {
  const geometry::Vector e = normal.unitOrthogonal(), f = normal.cross(e);
  const double ee = rise(e) + rise(-e), ff = rise(f) + rise(-f);
  const double ef = (rise(e + f) + rise(-e - f) - rise(e - f) - rise(f - e)) / 4;
  Eigen::Matrix2d hessian;
  hessian << ee, ef, ef, ff;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(hessian).eigenvalues();
}

}  // namespace morskin::support
