#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// A triangle mesh as files hold it: positions and, per triangle, three places in that array,
/// counter-clockwise seen from outside. Any connectivity, right or wrong, can be stored.
struct IndexedMesh {
  std::vector<Point> positions;                         ///< Angstrom
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< each < positions.size()
};

}  // namespace morskin::geometry
