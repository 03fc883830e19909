// Any bytes as the two files of an MSMS mesh: read, with corners that exist and finite coordinates,
// or turned down. What was read is written and read again alike. Whatever they are, both may be
// asked for their provenance.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/mesh_formats.h"
#include "tests/fuzz/msms_pair.h"
#include "tests/fuzz/require.h"

using namespace morskin;
using geometry::MeshFormat;

namespace {

geometry::IndexedMesh read(std::string_view vertices, std::string_view faces) {
  return geometry::parse_msms(vertices, "a.vert", faces, "a.face");
}

// What the files hold besides the mesh is not read, so any of it will do.
geometry::MeshAttributes attributes_of(const geometry::IndexedMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  geometry::MeshAttributes attributes;
  attributes.normals.assign(vertices, geometry::Vector(0, 0, 1));
  attributes.msms.sphere_count = 1;
  attributes.msms.spheres.assign(vertices, 0);
  attributes.msms.kinds.assign(vertices, 1);
  attributes.msms.face_kinds.assign(mesh.triangles.size(), 3);
  return attributes;
}

void look_at(const geometry::IndexedMesh& mesh) {
  for (const geometry::Point& p : mesh.positions) fuzz::require(p.allFinite());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) fuzz::require(corner < mesh.positions.size());
  }
  const geometry::MeshAttributes attributes = attributes_of(mesh);
  const auto again = read(geometry::serialized(mesh, MeshFormat::MsmsVertices, attributes),
                          geometry::serialized(mesh, MeshFormat::MsmsFaces, attributes));
  fuzz::require(again.triangles == mesh.triangles && again.positions == mesh.positions);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MsmsPair pair =
      fuzz::msms_pair(std::string_view(reinterpret_cast<const char*>(data), size));
  for (const std::string_view bytes : {pair.vertices, pair.faces}) {
    fuzz::require(geometry::mesh_formats::msms_provenance(bytes).entries.size() <= 64);
  }
  try {
    look_at(read(pair.vertices, pair.faces));
  } catch (const geometry::UnreadableInput&) {
  }
  return 0;
}
