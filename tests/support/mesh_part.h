#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::support {

/// The triangles of a mesh that keep(id) allows, without the vertices they leave behind.
template <class Keep>
geometry::IndexedMesh mesh_part(const geometry::IndexedMesh& mesh, Keep keep) {
  geometry::IndexedMesh result;
  std::vector<std::optional<std::uint32_t>> name(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!keep(t)) continue;
    std::array<std::uint32_t, 3> triangle = mesh.triangles[t];
    for (std::uint32_t& v : triangle) {
      if (!name[v]) {
        name[v] = static_cast<std::uint32_t>(result.positions.size());
        result.positions.push_back(mesh.positions[v]);
      }
      v = *name[v];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace morskin::support
