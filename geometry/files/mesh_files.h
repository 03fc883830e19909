#pragma once

// Triangle meshes in the files that other programs write and read.
//
// What each format keeps of an IndexedMesh:
//   PLY (binary or ASCII), OFF, OBJ   everything, every coordinate to the last bit
//   VTU                               the same; written only
//   STL                               single precision coordinates, no sharing of vertices
//   MSMS (.vert and .face)            three decimals as that program writes them; read only
//
// Any of them may be gzipped, whatever its name.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/indexed_mesh.h"

namespace morskin::geometry {

enum class MeshFormat {
  PlyBinary,  ///< little endian, coordinates as doubles
  PlyAscii,
  Off,
  Obj,
  Stl,  ///< binary; single precision by definition, so vertices closer than that may fall together
  Vtu,  ///< VTK unstructured grid (XML, base64) for ParaView
};

/// The format that a file's ending stands for, in upper or lower case; .ply means binary.
std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path);

/// The bytes of `mesh` in `format`. Numbers spelled in decimal are the shortest that read back as
/// the same double.
std::string serialized(const IndexedMesh& mesh, MeshFormat format);

/// Writes `mesh` to `path`, whole or not at all (see write_file_atomically).
///
/// @throws UnwritableOutput  also if the ending stands for no format
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, MeshFormat format);
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh);

/// Reads a mesh written by any program, of any format above but VTU. The content decides the
/// format; the ending is asked where the content leaves it open. Of an MSMS pair either file may be
/// named; the other is looked for beside it.
///
/// Polygons become fans about their first corner. Normals, colours, texture and other elements are
/// passed over. STL corners whose three coordinates have equal bits become one vertex.
///
/// @throws UnreadableInput  "file:line: what is wrong; what to do", for a malformed or truncated
///                          file, a coordinate that is not finite, a corner that does not exist
IndexedMesh read_mesh(const std::filesystem::path& path);

/// The mesh that `bytes` hold, gzipped or not; not MSMS, which takes two files.
///
/// @param source  the name to use in messages and, for its ending, to choose the format.
/// @throws UnreadableInput  as above
IndexedMesh parse_mesh(std::string_view bytes, const std::string& source);

}  // namespace morskin::geometry
