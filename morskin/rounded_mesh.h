#pragma once

#include <cstddef>

#include "geometry/indexed_mesh.h"

namespace morskin {

/// What single precision may take off a triangle's smallest angle, degrees.
inline constexpr double single_precision_loss_deg = 5;

/// How many triangles rounding turns over, leaves without area, or robs of more of their smallest
/// angle.
/// @param rounded  the mesh with other coordinates
std::size_t count_spoilt(const geometry::IndexedMesh& mesh, const geometry::IndexedMesh& rounded,
                         double most_lost_deg);

}  // namespace morskin
