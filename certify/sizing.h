#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/surface.h"

namespace morskin::certify {

using surface::Point;
using surface::SurfacePoint;
using surface::Vector;

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
  /// A larger length scale counts as this one, Angstrom: then C sets the size where the skin curves
  /// strongly and this where it does not. What is left, min(rho, this), is 1-Lipschitz and at most
  /// rho, and nothing else is asked of rho wherever [L] and [U] are used.
  double largest_length_scale = std::numeric_limits<double>::infinity();

  /// The largest C for which some Q allows both that refinement is proved to end and that the
  /// certificate's conditions c1 and c2 follow from [U]; a little less than 0.2017.
  static constexpr double largest_proved_C = 0.2;
  /// With a smaller C the sphere of one ball has more triangles than there are ids. A length below
  /// least_size, Angstrom, has to coordinates in the predicates' range nearly a double's precision.
  static constexpr double least_C = 1e-5, least_size = 1e-6;
  /// The Q that goes with a C unless another is asked for: the paper's 1.65, or, where C is so
  /// large that insertion might go on for ever with it, a little more than the least Q for which
  /// Q^2 > 2 + 4 C Q (papers/4.3-large-molecules.md).
  static double quality_for(double C) {
    return std::max(1.65, 1.003 * (2 * C + std::sqrt(4 * C * C + 2)));
  }
  /// What a front is laid with: these, or, where nothing is proved any more, the largest C for
  /// which all is, with a Q that makes no triangle larger than these allow. Coarsening does the
  /// rest.
  Sizing laid() const {
    if (!is_coarser_than_laid()) return *this;
    const double q = std::min(quality_for(largest_proved_C), C * Q / largest_proved_C);
    return {largest_proved_C, q, largest_length_scale};
  }
  bool is_coarser_than_laid() const { return C > largest_proved_C; }
  /// Whether refinement is proved to end: no insertion makes an edge that [L] forbids.
  bool is_refinement_proved_to_end() const { return Q * Q > 2 + 4 * C * Q; }
  /// Whether [U] makes the vertices an epsilon-sample with epsilon < 0.279, on which the theory of
  /// the restricted Delaunay triangulation rests. The certificate does without
  /// (papers/certificate.md).
  bool is_sample_proved_dense() const { return C * Q <= 0.215; }
  /// Whether [U] bounds every triangle's R below rho / sqrt 7, where conditions c1 and c2 of the
  /// certificate follow from it.
  bool is_tube_proved() const { return C * Q < 1 / std::sqrt(7.0); }

  /// What counts as the length scale.
  double scale(double length_scale) const { return std::min(length_scale, largest_length_scale); }

  // [excerpt: sizes]
  /// R_ab over its bound in [L]: above 1 is good.
  double edge_ratio(const SurfacePoint& a, const SurfacePoint& b) const {
    return Q * (a.position - b.position).norm() /
           (2 * C * scale(std::max(a.length_scale, b.length_scale)));
  }
  /// R_abc over its bound in [U]: below 1 is good.
  double triangle_ratio(double circumradius, double smallest_length_scale) const {
    return circumradius / (C * Q * scale(smallest_length_scale));
  }
  /// The smallest angle that [L] and [U] allow, degrees: 21.55 with the default constants.
  double least_angle_deg() const { return std::asin(1 / (Q * Q)) * 180 / M_PI; }
  // [/excerpt]

  /// Whether edge_ratio() surely is above some ratio, told without root or division; false where
  /// that is close.
  bool is_surely_longer(const SurfacePoint& a, const SurfacePoint& b, double ratio) const {
    constexpr double room = 1 + 1e-9;  // far above rounding
    const double least = 2 * C * scale(std::max(a.length_scale, b.length_scale)) * ratio;
    return Q * Q * (a.position - b.position).squaredNorm() > room * least * least;
  }
  /// Whether an edge breaks [L]: edge_ratio() is 1 or less.
  bool is_too_short(const SurfacePoint& a, const SurfacePoint& b) const {
    return !is_surely_longer(a, b, 1) && edge_ratio(a, b) <= 1;
  }

  /// Largest radius of the disk, tangent at a departure vertex, on whose rim new vertices are
  /// placed, over the length scale there: 0.208 with the default constants.
  ///
  /// Source:  section 4.2, r_a = 2 R sqrt(1 - (R / rho)^2) with R = C Q / (1 + 2 C Q).
  /// Erratum: the closed form printed there lacks the factor 2 (papers/errata.md, E3).
  double tangent_disk_share() const {
    const double R = C * Q / (1 + 2 * C * Q);
    return 2 * R * std::sqrt(1 - R * R);
  }

  /// The median edge over the length scale, where that changes little. A front lays nearly its own
  /// disk's radius, for which it takes 0.87 of the largest. Coarsening goes on until most triangles
  /// come near its limit; but an even mesh it leaves alone if the first vertex to go would already
  /// leave triangles beyond it, whose circles are as wide as the edges are long.
  double edge_share() const {
    const double laid_edge = usual_edge * laid().tangent_disk_share();
    const bool is_left_alone = !is_coarser_than_laid() || spare_limit * C * Q < 0.93 * laid_edge;
    return is_left_alone ? laid_edge : usual_coarse_edge * C * Q;
  }
  /// Edges of about this length, Angstrom, where C does not ask for shorter ones.
  void set_edge_length(double length) { largest_length_scale = length / edge_share(); }
  double edge_length() const { return largest_length_scale * edge_share(); }

  static constexpr double usual_edge = 0.85, usual_coarse_edge = 1.125;  ///< measured
  /// The share of [U] up to which coarsening takes out vertices that have no need to go.
  static constexpr double spare_limit = 0.75;
};

}  // namespace morskin::certify
