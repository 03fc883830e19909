// Any bytes as a mesh file: read, with corners that exist and finite coordinates, or turned down.
// What was read is looked at as `check` does, written in the exact formats and read again alike.
// Whatever it is, it may be asked for its provenance.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/glued_triangles.h"
#include "tests/fuzz/endings.h"
#include "tests/fuzz/require.h"

using namespace morskin;
using geometry::MeshFormat;

namespace {

void look_at(const geometry::IndexedMesh& mesh) {
  for (const geometry::Point& p : mesh.positions) fuzz::require(p.allFinite());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) fuzz::require(corner < mesh.positions.size());
  }
  const auto closed = geometry::closed_mesh(mesh.positions.size(), mesh.triangles);
  if (!closed.defect) {
    fuzz::require(!geometry::validate(closed.mesh));
    geometry::components(closed.mesh);
  }
  if (mesh.positions.empty()) return;
  for (const MeshFormat format : {MeshFormat::PlyBinary, MeshFormat::PlyAscii, MeshFormat::Off,
                                  MeshFormat::Vtu, MeshFormat::Msh}) {
    const auto again = geometry::parse_mesh(geometry::serialized(mesh, format), "again");
    fuzz::require(again.triangles == mesh.triangles && again.positions == mesh.positions);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  for (const auto provenance_of :
       {geometry::mesh_formats::ply_provenance, geometry::mesh_formats::off_provenance,
        geometry::mesh_formats::obj_provenance, geometry::mesh_formats::stl_provenance,
        geometry::mesh_formats::msms_provenance, geometry::mesh_formats::vtu_provenance,
        geometry::mesh_formats::msh_provenance}) {
    fuzz::require(provenance_of(bytes).entries.size() <= 64);
  }
  try {
    look_at(geometry::parse_mesh(bytes, fuzz::mesh_name(data[0])));
  } catch (const geometry::UnreadableInput&) {
  }
  return 0;
}
