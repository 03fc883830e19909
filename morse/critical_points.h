#pragma once

/// Critical points of a height or a squared distance on the skin (section 3.1), cell by cell.
///
/// In a mixed cell the gradient must be parallel to N(x) = M (x - z). For the height along V this
/// has a closed form: x = z + lambda M V, and G(x) = 0 gives lambda^2 = (w/2) / (V . M V). |lambda|
/// is the length scale there, sign(lambda) V the outward normal, and the Hessian of the height on
/// the tangent plane is -(1/lambda) M restricted to it.
///
/// For the squared distance from p it is (I - mu M) (x - z) = p - z, and G(x) = 0 is one equation
/// in mu, of degree 4 (distance_equation.h); the Hessian is 2 (I - mu M).
///
/// A point counts if it lies in the cell. Derivations: papers/3.1-morse-functions.md.

#include <string>
#include <vector>

#include "morse/critical_point.h"
#include "skin/skin_surface.h"

namespace morskin::morse {

struct CriticalPoints {
  std::vector<CriticalPoint> points;  ///< in the order of the cells
  /// Why the function may be no Morse function on this skin, with the position; empty if it is one:
  /// - a critical point so near a cell wall that rounding decides on which side it lies;
  /// - a Hessian with an eigenvalue that is zero within rounding;
  /// - two critical points that coincide within rounding;
  /// - a circle or sphere of critical points (squared distances from an axis or a centre of
  ///   symmetry of a patch), which is not in `points`.
  std::vector<std::string> degeneracies;

  std::size_t count(int index) const;
  /// minima - saddles + maxima: the Euler characteristic of the skin if nothing is degenerate.
  long euler_characteristic() const;
};

/// "at (x, y, z)", for messages.
std::string position_text(const Point& x);

/// @pre function.curvature >= 0; a height's direction is a unit vector; the skin is not singular.
CriticalPoints critical_points(const skin::SkinSurface& skin, const MorseFunction& function);

}  // namespace morskin::morse
