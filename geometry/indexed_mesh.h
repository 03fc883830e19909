#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// A triangle mesh as in files: positions and, by triangle, three indices into them,
/// counter-clockwise seen from outside. Any connectivity, valid or not.
struct IndexedMesh {
  std::vector<Point> positions;                         ///< Angstrom
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< each < positions.size()
};

}  // namespace morskin::geometry
