#pragma once

/// Protecting spheres about the critical points (sections 3.1, 4.1): where the front is expected to
/// change its topology.

#include <optional>
#include <span>
#include <vector>

#include "morse/critical_points.h"

namespace morskin::morse {

class ProtectingSpheres {
 public:
  ProtectingSpheres() = default;  ///< none
  /// @param radius_share  radius of a sphere over the length scale at its centre; it shrinks to
  /// half
  ///                      the distance to the nearest other critical point, so that no two overlap.
  ///                      Erratum: papers/errata.md, E15.
  ProtectingSpheres(const skin::SkinSurface& skin, std::span<const CriticalPoint> points,
                    double radius_share);
  /// @param radii  by point, Angstrom; where spheres overlap, the one with the lowest id counts
  ProtectingSpheres(const skin::SkinSurface& skin, std::span<const CriticalPoint> points,
                    std::vector<double> radii);

  /// The sphere that a point of the skin lies in, or nothing. O(1): each mixed cell knows the
  /// spheres that reach into it.
  std::optional<CriticalId> containing(const skin::SurfacePoint& p) const;

  double radius(CriticalId id) const { return radius_[id.index()]; }

 private:
  std::vector<Point> centres_;
  std::vector<double> radius_;
  std::vector<std::uint32_t> first_;  ///< by cell, into reaching_
  std::vector<CriticalId> reaching_;
};

}  // namespace morskin::morse
