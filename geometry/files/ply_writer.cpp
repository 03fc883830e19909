// Writes PLY, binary and ASCII.

#include <array>
#include <cstddef>
#include <cstring>

#include "geometry/files/mesh_formats.h"
#include "geometry/files/ply_header.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

static_assert(sizeof(Point) == 3 * sizeof(double));

void append_properties(std::string& text, std::span<const Attribute> attributes) {
  for (const Attribute& a : attributes) {
    for (const std::string& column : a.columns) {
      text += (a.is_whole ? "property int " : "property double ") + column + "\n";
    }
  }
}

// Appends the bytes of one vertex's or triangle's attributes.
void append_row(std::string& bytes, std::span<const Attribute> attributes, std::size_t row) {
  for (const Attribute& a : attributes) {
    const std::size_t width = a.columns.size();
    for (std::size_t k = row * width; k < (row + 1) * width; ++k) {
      const auto whole = static_cast<std::int32_t>(a.is_whole ? a.numbers[k] : 0);
      const void* const number = a.is_whole ? static_cast<const void*>(&whole) : &a.numbers[k];
      bytes.append(static_cast<const char*>(number), a.is_whole ? sizeof whole : sizeof(double));
    }
  }
}

std::string header_text(const IndexedMesh& mesh, std::string_view encoding,
                        const MeshAttributes& attributes) {
  std::string text = "ply\nformat ";
  text += encoding;
  text += " 1.0\ncomment Angstrom\n" + provenance_lines(attributes.provenance, "comment ") +
          "element vertex ";
  append_number(text, std::uint64_t{mesh.positions.size()});
  text += "\nproperty double x\nproperty double y\nproperty double z\n";
  append_properties(text, attributes.vertices);
  text += "element face ";
  append_number(text, std::uint64_t{mesh.triangles.size()});
  // "int" rather than "uint", the only type of corners that some readers know.
  text += "\nproperty list uchar int vertex_indices\n";
  append_properties(text, attributes.triangles);
  text += "end_header\n";
  return text;
}

std::string ply_with(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  std::string bytes = header_text(mesh, "binary_little_endian", attributes);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    bytes.append(reinterpret_cast<const char*>(mesh.positions[v].data()), sizeof(Point));
    append_row(bytes, attributes.vertices, v);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    bytes += '\3';
    bytes.append(reinterpret_cast<const char*>(mesh.triangles[t].data()), face_size - 1);
    append_row(bytes, attributes.triangles, t);
  }
  return bytes;
}

}  // namespace

std::string ply_binary(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  if (!attributes.vertices.empty() || !attributes.triangles.empty()) {
    return ply_with(mesh, attributes);
  }
  std::string bytes = header_text(mesh, "binary_little_endian", attributes);
  bytes.reserve(bytes.size() + sizeof(Point) * mesh.positions.size() +
                face_size * mesh.triangles.size());
  if (!mesh.positions.empty()) {
    bytes.append(reinterpret_cast<const char*>(mesh.positions.data()->data()),
                 sizeof(Point) * mesh.positions.size());
  }
  // Faces go through a small block, so that the large string is written only once.
  constexpr std::size_t block_faces = 1024;
  std::array<char, block_faces * face_size> block;
  for (std::size_t first = 0; first < mesh.triangles.size(); first += block_faces) {
    const std::size_t count = std::min(block_faces, mesh.triangles.size() - first);
    char* at = block.data();
    for (std::size_t i = 0; i < count; ++i, at += face_size) {
      *at = 3;
      std::memcpy(at + 1, mesh.triangles[first + i].data(), face_size - 1);
    }
    bytes.append(block.data(), count * face_size);
  }
  return bytes;
}

std::string ply_ascii(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  MeshAttributes without_numbers;
  without_numbers.provenance = attributes.provenance;
  std::string text = header_text(mesh, "ascii", without_numbers);
  text.reserve(text.size() + 60 * mesh.positions.size() + 24 * mesh.triangles.size());
  for (const Point& position : mesh.positions) append_position(text, position);
  for (const TriangleCorners& triangle : mesh.triangles) {
    text += '3';
    append_corners(text, triangle);
  }
  return text;
}

}  // namespace morskin::geometry::mesh_formats
