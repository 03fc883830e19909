#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/surface.h"

namespace morskin::certify {

using surface::Point;
using surface::SurfacePoint;
using surface::Vector;

/// Degrees: the largest angle that Delaunay refinement provably reaches (Chew 1993).
inline constexpr double guaranteed_angle_deg = 30;

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
  /// A larger length scale counts as this one, Angstrom: C sets the size where the skin curves
  /// strongly, this where it does not. [L] and [U] need only that min(rho, this) is 1-Lipschitz
  /// and at most rho.
  double largest_length_scale = std::numeric_limits<double>::infinity();

  /// Degrees, at most 60. Above 0, a certificate wants every angle at least this, each by itself,
  /// and only counts what breaks [L], which at some C insertions for angles must break. 0: it wants
  /// [L], or guaranteed_angle_deg.
  double claimed_angle_deg = 0;

  /// The largest C with a Q for which refinement provably ends and [U] implies c1 and c2 of the
  /// certificate; the bound is a little less than 0.2017.
  static constexpr double largest_proved_C = 0.2;
  /// The largest C with which nearly every skin is certified (papers/4.3-large-molecules.md).
  static constexpr double coarsest_C = 0.4;
  /// A smaller C lays more triangles on the sphere of one ball than there are ids. A size below
  /// min_size, Angstrom, nears the precision of doubles in the predicates' range.
  static constexpr double min_C = 1e-5, min_size = 1e-6;
  /// The default Q for a C: the paper's 1.65, or, where insertion might not end with it, a little
  /// above the smallest Q with Q^2 > 2 + 4 C Q (papers/4.3-large-molecules.md).
  static double quality_for(double C) {
    return std::max(1.65, 1.003 * (2 * C + std::sqrt(4 * C * C + 2)));
  }
  /// The sizing that a front is laid with: this one, or, beyond largest_proved_C, that C with a Q
  /// that makes no triangle larger than this sizing allows. Coarsening does the rest; edges limited
  /// by length are laid as long as they shall be.
  Sizing laid() const {
    if (!is_coarser_than_laid()) return *this;
    const double q = std::min(quality_for(largest_proved_C), C * Q / largest_proved_C);
    Sizing result{largest_proved_C, q, largest_length_scale, claimed_angle_deg};
    if (std::isfinite(largest_length_scale)) result.set_edge_length(edge_length());
    return result;
  }
  /// The sizing that the static method refines with: with a coarse C its edges are longer than
  /// edge_share() has them, so those limited by length get a smaller limit.
  Sizing sampled() const {
    Sizing result = *this;
    result.largest_length_scale *= std::min(1.0, edge_share() / (usual_sampled_edge * C * Q));
    return result;
  }
  bool is_coarser_than_laid() const { return C > largest_proved_C; }
  /// Whether no insertion makes an edge that [L] forbids.
  bool is_refinement_proved_to_end() const { return Q * Q > 2 + 4 * C * Q; }
  /// Whether [U] makes the vertices an epsilon-sample with epsilon < 0.279, the premise of the
  /// theory of restricted Delaunay triangulations. The certificate does not need it.
  bool is_sample_proved_dense() const { return C * Q <= 0.215; }
  /// Whether [U] keeps R below rho / sqrt 7, which implies c1 and c2 of the certificate.
  bool is_tube_proved() const { return C * Q < 1 / std::sqrt(7.0); }

  /// The length scale that counts.
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
  double angle_bound_deg() const { return std::asin(1 / (Q * Q)) * 180 / M_PI; }
  // [/excerpt]

  /// Whether edge_ratio() exceeds a ratio, without root or division; false where that is close.
  bool is_certainly_longer(const SurfacePoint& a, const SurfacePoint& b, double ratio) const {
    constexpr double margin = 1 + 1e-9;  // far above rounding
    const double bound = 2 * C * scale(std::max(a.length_scale, b.length_scale)) * ratio;
    return Q * Q * (a.position - b.position).squaredNorm() > margin * bound * bound;
  }
  /// Whether an edge breaks [L]: edge_ratio() is 1 or less.
  bool is_too_short(const SurfacePoint& a, const SurfacePoint& b) const {
    return !is_certainly_longer(a, b, 1) && edge_ratio(a, b) <= 1;
  }

  /// Largest radius of the tangent disk at a departure vertex, on whose rim new vertices lie, over
  /// the length scale there: 0.208 with the default constants.
  ///
  /// Source:  section 4.2, r_a = 2 R sqrt(1 - (R / rho)^2) with R = C Q / (1 + 2 C Q).
  /// Erratum: the closed form printed there lacks the factor 2 (papers/errata.md, E3).
  double tangent_disk_share() const {
    const double R = C * Q / (1 + 2 * C * Q);
    return 2 * R * std::sqrt(1 - R * R);
  }

  /// The median edge over the length scale, where rho varies little. A front's edges are nearly as
  /// long as its disk's radius, which is 0.87 of the largest and, for small C, has an equilateral
  /// triangle of 0.88 of the circumradius in [U]. Coarsening stops when most triangles are near
  /// spare_limit; it leaves an even mesh alone if removing one vertex already makes triangles
  /// beyond that limit.
  double edge_share() const {
    if (!is_coarser_than_laid()) {
      return std::min(usual_edge * tangent_disk_share(), usual_fine_edge * C * Q);
    }
    const double laid_edge = Sizing{C, Q}.laid().edge_share();
    const bool is_left_alone = spare_limit * C * Q < usual_hole * laid_edge;
    return is_left_alone ? laid_edge : usual_coarse_edge * C * Q;
  }
  /// Makes edges about this long, Angstrom, except where C makes them shorter.
  void set_edge_length(double length) { largest_length_scale = length / edge_share(); }
  double edge_length() const { return largest_length_scale * edge_share(); }

  static constexpr double usual_edge = 0.85, usual_fine_edge = 1.49, usual_coarse_edge = 1.125;
  /// Of the static method. The median is 1.27 where nothing is bent, and 1.14 with a tenth.
  static constexpr double usual_sampled_edge = 1.24;
  /// The share of [U] up to which coarsening removes vertices that may stay.
  static constexpr double spare_limit = 0.75;
  /// Circumradius of the triangles in the place of a vertex, over the edges of an even mesh: 1 with
  /// six neighbours; with five, 2 / (1 + 2 sin 36 deg) = 0.92 of the mean of its ten edges. The
  /// value is measured: where triangles may be 0.92 of the edge laid, its vertices begin to go, and
  /// the median is as laid on a ball with edges by length, and as of a coarse mesh on small balls.
  static constexpr double usual_hole = 0.93;
};

}  // namespace morskin::certify
