#pragma once

/// The two conditions of the certificate on single triangles (papers/certificate.md): with
/// N = grad G / 2 and n_t the triangle's normal, at every point p
///
///     (c1) upright   N(p) . n_t > 0        the flow carries the triangle one-to-one,
///     (c2) tube      |G(p)| < |N(p)|^2     and reaches the skin, past no critical point.
///
/// For fine triangles N at one corner proves both, as N is 1-Lipschitz. For coarse ones N at all
/// three does, as far as they lie in one cell, where N is an isometry; others are subdivided.

#include "certify/sizing.h"
#include "certify/triangle_bounds.h"

namespace morskin::certify {

/// Bounds on the errors of a triangle's corners.
struct CornerBounds {
  std::array<double, 3> max_values;  ///< of |G|, by corner, Angstrom^2
  double max_error;                  ///< of length scale times normal, off N, Angstrom

  double max_value() const { return std::max({max_values[0], max_values[1], max_values[2]}); }
};

struct TubeProof {
  bool is_upright = false;  ///< (c1)
  bool is_in_tube = false;  ///< (c2)
  /// Bound on the path of a point of the triangle to the skin, Angstrom. @pre holds()
  double max_path = 0;

  bool holds() const { return is_upright && is_in_tube; }
};

/// Bound on the length s of a path of the flow along which G changes by at most g, and |N| is at
/// least n at one end. |N| falls by no more than s, so G changes by 2 n s - s^2 at least while s is
/// below n, and by n^2 once it is beyond. Infinity where that bounds nothing.
double max_flow_path(double n, double g);

/// Tries to prove both conditions, first from the corners, then piece by piece.
TubeProof prove_tube(const surface::Surface& surface, const Corners& corners,
                     const TriangleBounds& triangle, const CornerBounds& bounds);

/// Whether both conditions hold by the same argument in plain doubles: for a mesher, not for a
/// proof. @pre the corners are where Surface::project put them
bool expects_tube(const surface::Surface& surface, const Corners& corners);
/// The same of a triangle that meets [U], which need not be looked at where that implies both.
inline bool expects_tube(const surface::Surface& surface, const Sizing& sizing,
                         const Corners& corners) {
  return sizing.is_tube_proved() || expects_tube(surface, corners);
}

}  // namespace morskin::certify
