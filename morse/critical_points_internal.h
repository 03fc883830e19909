#pragma once

/// The two halves of critical_points() and their common parts.

#include "morse/critical_points.h"

namespace morskin::morse {

/// A point at less than this share of its length scale from a wall may belong to either side.
inline constexpr double wall_doubt = 1e-9;

/// Adds a critical point if it lies in its cell, and a degeneracy if it may lie on a wall.
/// @param doubt  bound on the rounding of the point and the wall, Angstrom
/// @return       whether it was added
bool take(const skin::SkinSurface& skin, const CriticalPoint& critical, double doubt,
          CriticalPoints& result);

/// Both add the critical points and degeneracies of one cell.
void add_height_critical_points(const skin::SkinSurface& skin, skin::CellId cell,
                                const MorseFunction& height, CriticalPoints& result);
/// @param origin  of the squared distance
void add_distance_critical_points(const skin::SkinSurface& skin, skin::CellId cell,
                                  const MorseFunction& function, const Point& origin,
                                  CriticalPoints& result);

}  // namespace morskin::morse
