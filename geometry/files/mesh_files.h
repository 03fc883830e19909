#pragma once

// Triangle meshes in the files of other programs.
//
// The parts of an IndexedMesh that each format keeps:
//   PLY (binary or ASCII), OFF, OBJ   everything, every coordinate to the last bit
//   VTU, MSH                          the same; of curved triangles the corners are read
//   NPZ                               the same; written only
//   GLB                               single precision coordinates; written only
//   STL                               single precision coordinates, no sharing of vertices
//   MSMS (.vert and .face)            everything; three decimals where that program wrote them
//
// Binary PLY, VTU, NPZ, MSH and GLB take attributes as well (geometry/mesh_attributes.h).
// MSMS's need them.
// All hold provenance (geometry/provenance.h).
//
// Any of them may be gzipped, whatever its name.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "geometry/mesh_attributes.h"
#include "geometry/second_order_mesh.h"

namespace morskin::geometry {

enum class MeshFormat {
  PlyBinary,  ///< little endian, coordinates as doubles
  PlyAscii,
  Off,
  Obj,
  Stl,           ///< binary; single precision by definition, so close vertices may coincide
  Vtu,           ///< VTK unstructured grid (XML, base64) for ParaView
  Glb,           ///< glTF 2.0 in one file, for viewers and game engines
  Npz,           ///< NumPy arrays
  Msh,           ///< Gmsh, 4.1 as text
  MsmsVertices,  ///< with normals, and a partner of the same name with the other ending
  MsmsFaces,
};

/// The format of a file's ending, in upper or lower case; .ply means binary.
std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path);
/// Whether a format stores coordinates in single precision.
bool is_single(MeshFormat format);
/// The name down to the ending that tells the format: without .gz, and without the .unverified that
/// a mesh which is not certified has.
std::filesystem::path plain_name(const std::filesystem::path& path);

/// The bytes of `mesh` in `format`. Numbers spelled in decimal are the shortest that read back as
/// the same double.
/// @param attributes  for PlyBinary, Vtu, Npz and Msh, its vertices and triangles; for Glb, its
///                    vertices; for Glb and Npz, its normals if there are any; for Npz, its
///                    arrays; for MSMS's files, normals and its columns. For all, its provenance
/// @throws LimitReached  the mesh is too large for Glb
std::string serialized(const IndexedMesh& mesh, MeshFormat format,
                       const MeshAttributes& attributes = {});

/// Whether a format holds attributes of vertices.
bool has_vertex_data(MeshFormat format);

/// Whether a format has curved triangles: Vtu and Msh.
bool has_second_order(MeshFormat format);
/// The bytes of a mesh of curved triangles. @param attributes  of all nodes, and of the triangles
/// @pre has_second_order(format)
std::string serialized(const SecondOrderMesh& mesh, MeshFormat format,
                       const MeshAttributes& attributes);

/// The format of a file that is written from a mesh alone.
/// @throws UnwritableOutput  if the ending is of no format, or of one that takes more
MeshFormat plain_format_of(const std::filesystem::path& path);

/// Writes `mesh` to `path`, whole or not at all (see write_file_atomically).
///
/// @throws UnwritableOutput  also, without a format, as plain_format_of() does
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, MeshFormat format);
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh);

/// The mesh as a text file holds it whose coordinates have so many decimals.
IndexedMesh with_decimals(IndexedMesh mesh, int decimals);
/// The mesh as STL and GLB hold it, whose coordinates have single precision.
IndexedMesh in_single_precision(IndexedMesh mesh);

/// Reads a mesh of any format above that is not only written, by any program. The content decides
/// the format, and the ending where the content is ambiguous, that before .gz and .unverified where
/// there are these. `path` may name either file of an MSMS pair.
///
/// Polygons become fans about their first corner. Normals, colours, texture and other elements are
/// ignored. STL corners whose three coordinates have equal bits become one vertex.
///
/// @throws UnreadableInput  "file:line: what is wrong; what to do", for a malformed or truncated
///                          file, a coordinate that is not finite, a corner that does not exist
IndexedMesh read_mesh(const std::filesystem::path& path);

/// The names that the other file of an MSMS pair may have, the likeliest first: with the other
/// ending in small letters or capitals, as it is or gzipped. None for other files.
std::vector<std::filesystem::path> msms_partners(const std::filesystem::path& path);

/// A mesh with what its file says of its origin, true or not.
struct MeshFile {
  IndexedMesh mesh;
  std::optional<SecondOrderMesh> curved;  ///< if its triangles are; the mesh's vertices go first
  Provenance provenance;                  ///< empty if the file says nothing
  bool is_single_precision = false;       ///< by its format
};

/// The same, with the provenance.
/// @throws UnreadableInput  as above
MeshFile read_mesh_file(const std::filesystem::path& path);

/// What `bytes` hold, gzipped or not; not MSMS, which has two files.
///
/// @param source  the name for messages; its ending may decide the format.
/// @throws UnreadableInput  as above
MeshFile parse_mesh_file(std::string_view bytes, const std::string& source);
/// The mesh alone.
IndexedMesh parse_mesh(std::string_view bytes, const std::string& source);

/// The mesh in the two files of MSMS.
/// @param vertices_source, faces_source  the names for messages
/// @throws UnreadableInput  as above
IndexedMesh parse_msms(std::string_view vertices, const std::string& vertices_source,
                       std::string_view faces, const std::string& faces_source);

}  // namespace morskin::geometry
