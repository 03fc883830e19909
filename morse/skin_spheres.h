#pragma once

/// Protecting spheres about critical points of a skin.

#include <span>
#include <vector>

#include "morse/protecting_spheres.h"
#include "skin/skin_surface.h"

namespace morskin::morse {

/// With the radii of disjoint_radii().
ProtectingSpheres protecting_spheres(const skin::SkinSurface& skin,
                                     std::span<const CriticalPoint> points, double radius_share);
/// @param radii  by point, Angstrom; where spheres overlap, the one with the lowest id counts
ProtectingSpheres protecting_spheres(const skin::SkinSurface& skin,
                                     std::span<const CriticalPoint> points,
                                     std::vector<double> radii);

}  // namespace morskin::morse
