#include "app/snapshots.h"

#include <string>

#include "geometry/files/atomic_file.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/vtu_grid.h"

namespace morskin::app {
namespace {

std::string grid_text(const geometry::IndexedMesh& mesh, const front::Front& front,
                      const morse::MorseFunction& function) {
  geometry::VtuGrid grid;
  grid.points = mesh.positions;
  geometry::Attribute is_front{"front", {"front"}, {}, true};
  const auto close_cell = [&](geometry::VtuCell kind) {
    grid.ends.push_back(static_cast<std::int64_t>(grid.corners.size()));
    grid.kinds.push_back(kind);
    is_front.numbers.push_back(kind == geometry::VtuCell::Line);
  };
  for (const auto& triangle : mesh.triangles) {
    grid.corners.insert(grid.corners.end(), triangle.begin(), triangle.end());
    close_cell(geometry::VtuCell::Triangle);
  }
  for (std::size_t i = 0; i < front.capacity(); ++i) {
    const front::FrontEdgeId e{i};
    if (!front[e].is_open) continue;
    grid.corners.push_back(front[e].origin.value);
    grid.corners.push_back(front.target(e).value);
    close_cell(geometry::VtuCell::Line);
  }
  geometry::Attribute value{"value", {"value"}, {}};
  for (const geometry::Point& p : mesh.positions) value.numbers.push_back(function(p));
  grid.point_attributes = {&value, 1};
  grid.cell_attributes = {&is_front, 1};
  return geometry::vtu(grid);
}

}  // namespace

void write_snapshot(const std::filesystem::path& folder, std::size_t number,
                    const surface::Mesh& mesh) {
  geometry::write_file_atomically(
      folder / ("snapshot-" + std::to_string(number) + ".ply"),
      geometry::serialized(surface::indexed_mesh(mesh), geometry::MeshFormat::PlyBinary));
}

void write_snapshot(const std::filesystem::path& folder, std::size_t number,
                    const front::Snapshot& snapshot) {
  const geometry::IndexedMesh mesh = surface::indexed_mesh(snapshot.mesh);
  const std::string stem = "snapshot-" + std::to_string(number);
  geometry::write_file_atomically(folder / (stem + ".ply"),
                                  geometry::serialized(mesh, geometry::MeshFormat::PlyBinary));
  geometry::write_file_atomically(folder / (stem + ".vtu"),
                                  grid_text(mesh, snapshot.front, snapshot.function));
}

}  // namespace morskin::app
