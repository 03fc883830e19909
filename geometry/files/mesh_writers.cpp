// The bytes of meshes, by format.

#include <algorithm>
#include <array>

#include "geometry/files/mesh_files.h"
#include "geometry/files/mesh_formats.h"

namespace morskin::geometry {

std::string serialized(const IndexedMesh& mesh, MeshFormat format,
                       const MeshAttributes& attributes) {
  switch (format) {
    case MeshFormat::PlyBinary:
      return mesh_formats::ply_binary(mesh, attributes);
    case MeshFormat::PlyAscii:
      return mesh_formats::ply_ascii(mesh, attributes);
    case MeshFormat::Off:
      return mesh_formats::off(mesh, attributes.provenance);
    case MeshFormat::Obj:
      return mesh_formats::obj(mesh, attributes.provenance);
    case MeshFormat::Stl:
      return mesh_formats::stl(mesh, attributes.provenance);
    case MeshFormat::Vtu:
      return mesh_formats::vtu(mesh, attributes);
    case MeshFormat::Glb:
      return mesh_formats::glb(mesh, attributes);
    case MeshFormat::Npz:
      return mesh_formats::npz(mesh, attributes);
    case MeshFormat::Msh:
      return mesh_formats::msh(mesh, attributes);
    case MeshFormat::MsmsVertices:
      return mesh_formats::msms_vertices(mesh, attributes);
    case MeshFormat::MsmsFaces:
      return mesh_formats::msms_faces(mesh, attributes);
  }
  return {};
}

bool has_vertex_data(MeshFormat format) {
  constexpr std::array formats{MeshFormat::PlyBinary, MeshFormat::Vtu, MeshFormat::Glb,
                               MeshFormat::Npz, MeshFormat::Msh};
  return std::ranges::find(formats, format) != formats.end();
}

bool has_second_order(MeshFormat format) {
  return format == MeshFormat::Vtu || format == MeshFormat::Msh;
}

std::string serialized(const SecondOrderMesh& mesh, MeshFormat format,
                       const MeshAttributes& attributes) {
  if (format == MeshFormat::Vtu) return mesh_formats::vtu(mesh, attributes);
  return mesh_formats::msh(mesh, attributes);
}

}  // namespace morskin::geometry
