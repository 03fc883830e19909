#pragma once

#include "certify/sizing.h"
#include "geometry/indexed_mesh.h"
#include "surface/mesh.h"

namespace morskin::ablation {

/// Edges that break [L] and triangles that break [U].
struct Breaches {
  std::size_t short_edges = 0, big_triangles = 0;
};

/// Of a mesh that may have a boundary. @pre nothing has been removed since it was compacted
Breaches count_breaches(const certify::Sizing& sizing, const surface::Mesh& mesh);

/// How many angles of all triangles are smaller.
std::size_t angles_below(double degrees, const geometry::IndexedMesh& mesh);

}  // namespace morskin::ablation
