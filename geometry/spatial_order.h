#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::geometry {

/// A biased randomized insertion order: rounds, each a random sample seven times as large as all
/// earlier ones together, and a Hilbert curve through each round. Deterministic.
///
/// @param  threads  may be used
/// @pre    all positions are finite.
/// Source: Amenta, Choi & Rote 2003, Incremental constructions con BRIO; Hamilton & Rau-Chaplin
///         2008, Compact Hilbert indices (the curve).
struct SpatialOrder {
  std::vector<AtomId> ids;        ///< every id once
  std::vector<std::size_t> ends;  ///< of the rounds, ascending
};
SpatialOrder spatial_order(std::span<const WeightedPoint> points, unsigned threads = 1);

/// The index of the cell (x, y, z) on the Hilbert curve of the cube [0, 2^bits)^3.
///
/// Law: a bijection onto [0, 2^(3 bits)); consecutive cells share a face.
/// @pre 1 <= bits <= 21 and x, y, z < 2^bits.
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits);

}  // namespace morskin::geometry
