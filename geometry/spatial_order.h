#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::geometry {

/// An order of insertion that is random in the large and local in the small: rounds, each a random
/// sample seven times as large as all before it together, and a Hilbert curve through each round.
///
/// @return every id once; the same order for the same points.
/// @pre    all positions are finite.
/// Source: Amenta, Choi & Rote 2003, Incremental constructions con BRIO; Hamilton & Rau-Chaplin
///         2008, Compact Hilbert indices (the curve).
std::vector<AtomId> spatial_order(std::span<const WeightedPoint> points);

/// How far along the Hilbert curve that fills the cube [0, 2^bits)^3 the cell (x, y, z) comes.
///
/// Law: a bijection onto [0, 2^(3 bits)); consecutive cells share a face.
/// @pre 1 <= bits <= 21 and x, y, z < 2^bits.
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits);

}  // namespace morskin::geometry
