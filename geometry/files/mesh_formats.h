#pragma once

// Inside mesh_files: one parser and one writer per format, and their common parts.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/files/text_lines.h"
#include "geometry/indexed_mesh.h"
#include "geometry/mesh_attributes.h"
#include "geometry/second_order_mesh.h"

namespace morskin::geometry::mesh_formats {

/// What a file holds of a mesh.
struct ParsedMesh {
  IndexedMesh mesh;
  std::optional<SecondOrderMesh> curved;  ///< if the triangles are; the mesh's vertices go first
};

/// Each parses all bytes of a file; `source` is its name for messages. @throws UnreadableInput
IndexedMesh parse_ply(std::string_view bytes, const std::string& source);
IndexedMesh parse_off(std::string_view bytes, const std::string& source);
IndexedMesh parse_obj(std::string_view bytes, const std::string& source);
IndexedMesh parse_stl(std::string_view bytes, const std::string& source);
ParsedMesh parse_vtu(std::string_view bytes, const std::string& source);
ParsedMesh parse_msh(std::string_view bytes, const std::string& source);
/// The two files of an MSMS mesh, each by its bytes and its name.
struct MsmsFile {
  std::string_view bytes;
  std::string source;
};
IndexedMesh parse_msms(const MsmsFile& vertices, const MsmsFile& faces);

std::string ply_binary(const IndexedMesh& mesh, const MeshAttributes& attributes = {});
std::string ply_ascii(const IndexedMesh& mesh, const MeshAttributes& attributes = {});
std::string off(const IndexedMesh& mesh, const Provenance& provenance = {});
std::string obj(const IndexedMesh& mesh, const Provenance& provenance = {});
std::string stl(const IndexedMesh& mesh, const Provenance& provenance = {});
std::string vtu(const IndexedMesh& mesh, const MeshAttributes& attributes = {});
std::string msms_vertices(const IndexedMesh& mesh, const MeshAttributes& attributes);
std::string msms_faces(const IndexedMesh& mesh, const MeshAttributes& attributes);

std::string glb(const IndexedMesh& mesh, const MeshAttributes& attributes = {});
std::string npz(const IndexedMesh& mesh, const MeshAttributes& attributes = {});
std::string msh(const IndexedMesh& mesh, const MeshAttributes& attributes = {});

/// The same with curved triangles. @param attributes  of all nodes, and of the triangles
std::string vtu(const SecondOrderMesh& mesh, const MeshAttributes& attributes);
std::string msh(const SecondOrderMesh& mesh, const MeshAttributes& attributes);

/// Whether these are the normals, which `all` has in their own place too.
inline bool is_normal(const Attribute& attribute, const MeshAttributes& all) {
  return attribute.name == "normal" && !all.normals.empty();
}

/// The entries as lines `<start>morskin: key value`.
std::string provenance_lines(const Provenance& provenance, std::string_view start);
/// The entries in one line, `# morskin: key value; key value`; empty if there are none.
std::string provenance_line(const Provenance& provenance);

/// What the bytes of a file say of its origin, in each format's place for it.
Provenance ply_provenance(std::string_view bytes);
Provenance off_provenance(std::string_view bytes);
Provenance obj_provenance(std::string_view bytes);
Provenance stl_provenance(std::string_view bytes);
Provenance msms_provenance(std::string_view bytes);
Provenance vtu_provenance(std::string_view bytes);
Provenance msh_provenance(std::string_view bytes);
/// Takes the entry "key value".
void take_entry(Provenance& provenance, std::string_view text);

/// Appends the polygon's triangles, all with its first corner. @pre at least three corners.
void append_fan(IndexedMesh& mesh, std::span<const std::uint32_t> polygon);

/// Appends " a b c\n", the corners counted from `first`.
void append_corners(std::string& text, const TriangleCorners& triangle, std::uint64_t first = 0);

/// Appends "x y z\n" in shortest decimals.
void append_position(std::string& text, const Point& position);

/// A number with so many decimals.
std::string fixed(double number, int decimals);

/// The nearest float; infinite beyond all.
double in_single_precision(double number);

/// Takes the three coordinates at the front of `fields`.
/// @param lines  at their line, for messages
/// @throws UnreadableInput  if there are not three finite numbers
Point take_position(std::string_view& fields, const TextLines& lines);

/// Whether the count of triangles in a binary STL header fits the number of bytes.
bool looks_like_binary_stl(std::string_view bytes);

}  // namespace morskin::geometry::mesh_formats
