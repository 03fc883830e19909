#pragma once

/// The two conditions of the certificate on single triangles (papers/certificate.md): with
/// N = grad G / 2 and n_t the triangle's normal, at every point p
///
///     (c1) upright   N(p) . n_t > 0        the flow carries the triangle one-to-one,
///     (c2) tube      |G(p)| < |N(p)|^2     and reaches the skin, past no critical point.
///
/// For fine triangles a bound from the corners proves both. Coarse ones are subdivided: N is
/// 1-Lipschitz, so the centroid of a piece bounds G and N on all of it.

#include "certify/triangle_geometry.h"

namespace morskin::certify {

struct TubeProof {
  bool is_upright = false;  ///< (c1)
  bool is_in_tube = false;  ///< (c2)
  /// Bound on the path of a point of the triangle to the skin, Angstrom. @pre holds()
  double max_path = 0;

  bool holds() const { return is_upright && is_in_tube; }
};

/// Bound on the length s of a path of the flow to the skin from a point with |G| <= g: where
/// |N| >= n at one end, |N| falls by no more than s, so 2 n s - s^2 <= g. Infinity where that
/// bounds nothing.
double max_flow_path(double n, double g);

/// Tries to prove both conditions, first from the corners, then piece by piece.
/// @param circle  the triangle's
/// @param max_G   bound on |G| at the corners, Angstrom^2
TubeProof prove_tube(const surface::Surface& surface, const Corners& corners,
                     const Circumcircle& circle, double max_G);

}  // namespace morskin::certify
