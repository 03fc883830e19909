#pragma once

/// Every crossing of a segment with the skin, cell by cell. Inside one mixed cell G is a quadratic
/// along a line, so its zeros have a closed form and none is missed. But on a line that runs in a
/// wall, as from atom to atom of a lattice, some may be, or the walk comes to no end (is_complete).
/// Nothing that is proved rests on them.

#include "skin/skin_surface.h"

namespace morskin::skin {

/// @param skin  a SkinSurface or a LevelSet
/// @param hint  a cell near p; the nearer, the shorter the walk.
/// @pre    both ends are finite.
template <class Skin>
surface::LineCrossings line_crossings(const Skin& skin, const Point& p, const Point& q,
                                      CellId hint);

}  // namespace morskin::skin
