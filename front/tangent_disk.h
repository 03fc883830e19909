#pragma once

#include <cmath>
#include <optional>

#include "certify/sizing.h"
#include "certify/triangle_geometry.h"
#include "front/front.h"
#include "surface/surface.h"

namespace morskin::front {

inline constexpr double sixty_degrees = M_PI / 3;

/// Where new vertices go, in units of the tangent disk's radius r_a (section 4.2).
struct Spacing {
  double disk_share = 0.87;  ///< r_a over its upper bound; papers/4.2-curvature-adaptation.md
  /// Largest circumradius of an equilateral triangle of a fan, over the bound in [U]. For small C
  /// that bound, not r_a's, is the nearer: with 0.87 alone it would be 1.005.
  double fan_share = 0.88;
  bool is_by_both_ends = true;  ///< r_a goes by the smaller length scale of centre and rim, as [U]
  bool rounds_up = false;       ///< sectors of a fan have at most 60 degrees, not 45 to 75
  double bowl_gap = 1.9;        ///< smallest distance of a minimum from the rim of another's bowl
  double vertex_gap = 0.6;      ///< smallest distance of a new vertex from a front vertex
  double edge_gap = 0.4;        ///< and from a front edge
  double view = 2.2;            ///< radius in which the guard gathers the front
  double wing_angle_deg = 75;   ///< front angles below this are closed at once
  /// Where the length scale shrinks ahead of the front, as in a funnel, edges left as they are
  /// would soon be longer than it. So a corner is filled instead of closed when its triangle's
  /// circumradius exceeds `largest_ear`, and an edge longer than `longest_edge` gets a vertex of
  /// its own, at a height of `long_edge_height` over its middle.
  double largest_ear = 1;
  double longest_edge = 1.7;
  double long_edge_height = 0.7;

  /// The number of sectors of a fan that fills a bare angle, as a whole number.
  double sectors(double angle) const {
    return rounds_up ? std::ceil(angle / sixty_degrees) : std::round(angle / sixty_degrees);
  }
};

/// The disk, tangent at a departure vertex, on whose rim new vertices are placed (section 4.2).
class TangentDisk {
 public:
  TangentDisk(const surface::Surface& surface, const certify::Sizing& sizing,
              const Spacing& spacing = {});

  const Spacing& spacing() const { return spacing_; }
  double share() const { return share_; }  ///< r_a over rho
  double wing_cosine() const { return wing_cosine_; }
  /// The radius of the guard's view over rho.
  double view_share() const;

  /// Angstrom, for a length scale.
  double radius(double length_scale) const { return share_ * sizing_.scale(length_scale); }
  /// In one direction, for the smaller length scale of centre and rim. The rim's is extrapolated
  /// from the patch of the centre.
  double radius(const SurfacePoint& centre, const Vector& direction) const;
  /// All that a fan or a closed corner at p could add lies this near, Angstrom, with a disk's
  /// radius to spare.
  double working_radius(const SurfacePoint& p) const { return 2 * radius(p.length_scale); }
  /// The rim's point in one direction, projected to the surface; nothing where that fails.
  std::optional<SurfacePoint> rim_point(const SurfacePoint& centre, const Vector& direction) const;
  std::optional<SurfacePoint> projected(const Point& x, geometry::CellId hint) const {
    return surface_.project(x, hint);
  }

  /// Whether the triangle that closes a corner at p is not much bigger than those of a fan there.
  bool is_ear_small(const certify::Circumcircle& ear, const SurfacePoint& p) const {
    return ear.radius <= spacing_.largest_ear * radius(p.length_scale);
  }
  /// Whether an edge is longer than the sizes at its ends allow.
  bool is_edge_long(const SurfacePoint& p, const SurfacePoint& w, double squared_length) const;
  /// Whether an edge of this length may be long, by one end: false for most that are not.
  bool may_edge_be_long(double length_scale, double length) const {
    // rho is 1-Lipschitz.
    return length > spacing_.longest_edge * share_ * sizing_.scale(length_scale - length);
  }

 private:
  const surface::Surface& surface_;
  certify::Sizing sizing_;
  Spacing spacing_;
  double share_;
  double wing_cosine_;
};

}  // namespace morskin::front
