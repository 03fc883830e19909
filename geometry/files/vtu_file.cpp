#include <cstdint>

#include "geometry/files/mesh_formats.h"
#include "geometry/files/vtu_grid.h"

namespace morskin::geometry::mesh_formats {

std::string vtu(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  VtuGrid grid;
  grid.points = mesh.positions;
  grid.corners.reserve(3 * mesh.triangles.size());
  grid.ends.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    grid.corners.insert(grid.corners.end(), triangle.begin(), triangle.end());
    grid.ends.push_back(static_cast<std::int64_t>(grid.corners.size()));
  }
  grid.kinds.assign(mesh.triangles.size(), VtuCell::Triangle);
  grid.point_attributes = attributes.vertices;
  grid.cell_attributes = attributes.triangles;
  grid.field_data = attributes.provenance.entries;
  return geometry::vtu(grid);
}

}  // namespace morskin::geometry::mesh_formats
