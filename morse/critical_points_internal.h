#pragma once

/// The two halves of critical_points(), and what they share.

#include "morse/critical_points.h"

namespace morskin::morse {

/// A point this near a wall, relative to its length scale, may be taken for either side's.
inline constexpr double wall_doubt = 1e-9;

/// "at (x, y, z)", for messages.
std::string place_text(const Point& x);

/// Takes a critical point if it lies in its cell, and reports it if it may lie on a wall.
/// @param doubt  how far rounding may have moved it or the wall, Angstrom.
/// @return       whether it was taken.
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
