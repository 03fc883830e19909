#pragma once

#include <algorithm>
#include <cmath>

#include "skin/skin_surface.h"

namespace morskin::refine {

using skin::Point;
using skin::SurfacePoint;
using skin::Vector;

/// The two size conditions of section 2.2,
///
///     [L]  R_ab  > (C/Q) rho_ab     for every edge,      rho_ab  = max of the two length scales
///     [U]  R_abc < C Q rho_abc      for every triangle,  rho_abc = min of the three
///
/// with R_ab half the edge's length and R_abc the triangle's circumradius. Together they keep every
/// angle above asin(1/Q^2). C sets how closely the mesh follows the surface, Q its quality.
struct Sizing {
  double C = 0.08;
  double Q = 1.65;

  // [excerpt: sizes]
  /// R_ab over its bound in [L]: above 1 is good.
  double edge_ratio(const SurfacePoint& a, const SurfacePoint& b) const {
    return Q * (a.position - b.position).norm() /
           (2 * C * std::max(a.length_scale, b.length_scale));
  }
  /// R_abc over its bound in [U]: below 1 is good.
  double triangle_ratio(double circumradius, double smallest_length_scale) const {
    return circumradius / (C * Q * smallest_length_scale);
  }
  /// The smallest angle that [L] and [U] allow, degrees: 21.55 with the default constants.
  double least_angle_deg() const { return std::asin(1 / (Q * Q)) * 180 / M_PI; }
  // [/excerpt]

  /// Largest radius of the disk, tangent at a departure vertex, on whose rim new vertices are
  /// placed, over the length scale there: 0.208 with the default constants.
  ///
  /// Source:  section 4.2, r_a = 2 R sqrt(1 - (R / rho)^2) with R = C Q / (1 + 2 C Q).
  /// Erratum: the closed form printed there lacks the factor 2 (papers/README.md, E3).
  double tangent_disk_share() const {
    const double R = C * Q / (1 + 2 * C * Q);
    return 2 * R * std::sqrt(1 - R * R);
  }
};

}  // namespace morskin::refine
