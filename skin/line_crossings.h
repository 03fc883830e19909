#pragma once

/// Every crossing of a segment with the skin, cell by cell. Inside one mixed cell G is a quadratic
/// along a line, so its zeros have a closed form and none is missed, but for rounding. A line may
/// run in walls and in cells without volume, as from atom to atom of a lattice: there the cells'
/// definition says where each ends (SkinSurface::last_in). Nothing that is proved rests on the
/// crossings.

#include "skin/skin_surface.h"

namespace morskin::skin {

/// @param skin  a SkinSurface or a LevelSet
/// @param hint  a cell near p; the nearer, the shorter the walk.
/// @pre    both ends are finite.
template <class Skin>
surface::LineCrossings line_crossings(const Skin& skin, const Point& p, const Point& q,
                                      CellId hint);

}  // namespace morskin::skin
