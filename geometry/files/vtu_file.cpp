#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/files/mesh_formats.h"
#include "geometry/files/vtu_grid.h"

namespace morskin::geometry::mesh_formats {

namespace {

template <std::size_t Nodes>
std::string vtu(const std::vector<Point>& points,
                const std::vector<std::array<std::uint32_t, Nodes>>& triangles, VtuCell kind,
                const MeshAttributes& attributes) {
  VtuGrid grid;
  grid.points = points;
  grid.corners.reserve(Nodes * triangles.size());
  grid.ends.reserve(triangles.size());
  for (const auto& triangle : triangles) {
    grid.corners.insert(grid.corners.end(), triangle.begin(), triangle.end());
    grid.ends.push_back(static_cast<std::int64_t>(grid.corners.size()));
  }
  grid.kinds.assign(triangles.size(), kind);
  grid.point_attributes = attributes.vertices;
  grid.cell_attributes = attributes.triangles;
  grid.field_data = attributes.provenance.entries;
  return geometry::vtu(grid);
}

}  // namespace

std::string vtu(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  return vtu(mesh.positions, mesh.triangles, VtuCell::Triangle, attributes);
}

std::string vtu(const SecondOrderMesh& mesh, const MeshAttributes& attributes) {
  return vtu(mesh.nodes, mesh.triangles, VtuCell::QuadraticTriangle, attributes);
}

}  // namespace morskin::geometry::mesh_formats
