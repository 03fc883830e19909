#pragma once

/// Protecting spheres that overlap.

#include <utility>
#include <vector>

#include "morse/critical_points.h"

namespace morskin::morse {

/// By critical point, the radius of a protecting sphere of full size, Angstrom.
/// @param radius_share  over the length scale at the centre
std::vector<double> full_radii(const std::vector<CriticalPoint>& points, double radius_share);

/// All pairs of overlapping spheres about critical points, the smaller id first, in order.
/// Near-linear in the points and pairs.
/// @param radii  by critical point, Angstrom; a sphere of radius 0 overlaps nothing.
std::vector<std::pair<CriticalId, CriticalId>> overlapping_spheres(
    const std::vector<CriticalPoint>& points, const std::vector<double>& radii);

/// The radii after the spheres of each of these pairs have shrunk in proportion until they touch.
std::vector<double> shrunk_apart(const std::vector<CriticalPoint>& points,
                                 const std::vector<double>& radii,
                                 const std::vector<std::pair<CriticalId, CriticalId>>& overlapping);

}  // namespace morskin::morse
