#pragma once

/// How much room there is in a void, before anything is meshed: proved bounds.
///
/// Cubes are cut into eight until G, of which N is known and changes by no more than the distance,
/// has one sign in each, or is so nearly linear in it that planes bound the part where G > 0.

#include <cstdint>

#include "skin/skin_components.h"

namespace morskin::skin {

/// Angstrom^3.
struct VolumeBounds {
  double low = 0, high = 0;

  double middle() const { return (low + high) / 2; }
};

/// Of the part of the complement alone, without the bodies in it. Which void a cube lies in is
/// walked in doubles (SkinComponents); all else is proved.
/// @param fineness  of the smallest cubes beside the length scale, above 0: the bounds differ by
///                  some 3 fineness^2 times the volume of a round void
/// @pre cavity < topology.voids.size()
VolumeBounds void_volume(const SkinSurface& skin, const DualComplex& topology, std::uint32_t cavity,
                         double fineness = 1.0 / 16);

}  // namespace morskin::skin
