#pragma once

/// A step of void_volume, for tests.

#include "skin/void_volume.h"
#include "surface/enclosure.h"

namespace morskin::skin {

/// The shares of a cube that are surely, and may be, in the complement.
/// @param at     of G and N at the cube's centre; N is taken for at.half_gradient
/// @param slack  bound on what G differs from a linear function by in the cube
VolumeBounds cut_shares(const surface::Enclosure& at, double half_side, double slack);

}  // namespace morskin::skin
