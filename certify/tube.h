#pragma once

/// The two conditions of the certificate that each triangle has to meet by itself
/// (papers/certificate.md): with N = grad G / 2 and n_t the triangle's normal, at every point p
///
///     (c1) upright   N(p) . n_t > 0        the flow carries the triangle one-to-one,
///     (c2) tube      |G(p)| < |N(p)|^2     and reaches the skin, past no critical point.
///
/// Fine triangles meet them by a bound from their corners alone. For a coarse one G and N are
/// looked at on ever smaller pieces: N is 1-Lipschitz, so a few places speak for all.

#include <array>

#include "certify/triangle_geometry.h"

namespace morskin::certify {

struct TubeProof {
  bool is_upright = false;  ///< (c1)
  bool is_in_tube = false;  ///< (c2)
  /// No farther than this does the flow move a point of the triangle, Angstrom. @pre holds()
  double way = 0;

  bool holds() const { return is_upright && is_in_tube; }
};

/// How far the flow can have moved a point onto the skin where |G| was at most g: |N| is at least n
/// at one end of the way and falls by no more than the way is long, so the way s has 2 n s - s^2 <=
/// g. Infinity where that bounds nothing.
double longest_way(double n, double g);

/// Tries to prove both for a triangle, first from its corners, then piece by piece.
///
/// @param circle   the triangle's own
/// @param most_G   |G| at the corners, Angstrom^2, at most
TubeProof prove_tube(const surface::Surface& surface,
                     const std::array<const SurfacePoint*, 3>& corners, const Circumcircle& circle,
                     double most_G);

}  // namespace morskin::certify
