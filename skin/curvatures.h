#pragma once

/// Second-order data of the skin at one of its points, in closed form from the quadric of its cell.
/// Not in the paper, which needs the larger curvature only.

#include <array>
#include <cmath>

#include "skin/patch.h"
#include "surface/surface_point.h"

namespace morskin::skin {

/// Curvatures are positive where the body is convex: 1 / r on a ball of radius r, -1 / r on the
/// wall of a round void.
struct Curvatures {
  std::array<double, 2> principal;   ///< k1 >= k2, 1/Angstrom
  std::array<Vector, 2> directions;  ///< theirs, unit; first x second = outer normal

  double mean() const { return (principal[0] + principal[1]) / 2; }  ///< H, 1/Angstrom
  double gaussian() const { return principal[0] * principal[1]; }    ///< K, 1/Angstrom^2
  /// Between -1, the bottom of a pit, and 1, the top of a bump; 0 on an even saddle.
  /// Source: Koenderink & van Doorn 1992, with the sign that surface learning gives it.
  double shape_index() const {
    return 2 / M_PI * std::atan2(principal[0] + principal[1], principal[0] - principal[1]);
  }
  /// 1/Angstrom. Source: Koenderink & van Doorn 1992.
  double curvedness() const { return std::hypot(principal[0], principal[1]) / std::sqrt(2.0); }
};

/// With M = sign (I - 2 a a^T) the derivative of N (patch.h), the normal's is M / rho restricted to
/// the tangent plane: there sign / rho across the axis a, and along its projection, whose square is
/// 1 - (a . n)^2, sign (2 (a . n)^2 - 1) / rho. A sphere has no axis. Where both are equal every
/// direction will do; the same one is taken every time.
/// @param x  in the patch's cell
Curvatures curvatures(const Patch& patch, const surface::SurfacePoint& x);

}  // namespace morskin::skin
