// Reads PLY, binary and ASCII.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/ply_body.h"
#include "geometry/files/ply_header.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

constexpr double max_vertices = std::numeric_limits<std::uint32_t>::max();

static_assert(sizeof(Point) == 3 * sizeof(double));

// Throws if the rest of the file is too short for the count of elements in the header.
template <class Body>
void check_length(const Body& body, const PlyElement& element) {
  std::size_t min_size = 0;
  for (const PlyProperty& property : element.properties) {
    min_size += body.min_size(property.count_type.value_or(property.type));
  }
  if (min_size > 0 && element.count > body.rest().size() / min_size) {
    throw UnreadableInput(body.location() + ": the file is too short for " +
                          std::to_string(element.count) + " elements " + quoted(element.name) +
                          "; write it again");
  }
}

// A whole number from 0 to 2^32 - 1.
template <class Body>
std::uint32_t take_whole(Body& body, PlyScalar type) {
  const double value = body.take(type);
  if (!(value >= 0 && value <= max_vertices) || value != std::floor(value)) {
    throw UnreadableInput(body.location() + ": " + in_digits(value, 12) +
                          " is no corner or count; write the mesh again");
  }
  return static_cast<std::uint32_t>(value);
}

template <class Body>
void skip_property(Body& body, const PlyProperty& property) {
  const std::uint32_t count = property.is_list() ? take_whole(body, *property.count_type) : 1;
  for (std::uint32_t i = 0; i < count; ++i) body.take(property.type);
}

std::optional<int> axis_of(const PlyProperty& property) {
  if (property.is_list() || property.name.size() != 1) return std::nullopt;
  const std::size_t axis = std::string_view("xyz").find(property.name[0]);
  if (axis == std::string_view::npos) return std::nullopt;
  return static_cast<int>(axis);
}

void check_finite(const IndexedMesh& mesh, const std::string& source) {
  bool all_finite = true;
  for (const Point& position : mesh.positions) all_finite &= position.allFinite();
  if (all_finite) return;
  std::size_t vertex = 0;
  while (mesh.positions[vertex].allFinite()) ++vertex;
  throw UnreadableInput(source + ": vertex " + std::to_string(vertex) +
                        " has a coordinate that is not finite; remove it");
}

// Three doubles and nothing else, in our byte order: the layout this program writes.
bool is_plain(const PlyBinaryBody& body, const PlyElement& vertices) {
  if (body.is_swapped() || vertices.properties.size() != 3) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const PlyProperty& property = vertices.properties[static_cast<std::size_t>(axis)];
    if (axis_of(property) != axis || property.type != PlyScalar::Double) return false;
  }
  return true;
}

template <class Body>
void read_vertices(Body& body, const PlyElement& element, IndexedMesh& mesh) {
  std::array<int, 3> times{};  // each axis is named
  for (const PlyProperty& property : element.properties) {
    if (const std::optional<int> axis = axis_of(property)) ++times[static_cast<std::size_t>(*axis)];
  }
  if (times != std::array{1, 1, 1})
    throw UnreadableInput(body.location() + ": vertices need x, y and z; write it again");
  if (static_cast<double>(element.count) > max_vertices) {
    throw UnreadableInput(body.location() + ": too many vertices; at most 2^32 - 1 are read");
  }
  check_length(body, element);
  mesh.positions.resize(element.count, Point::Zero());
  for (Point& position : mesh.positions) {
    for (const PlyProperty& property : element.properties) {
      if (const std::optional<int> axis = axis_of(property)) {
        position[*axis] = body.take(property.type);
      } else {
        skip_property(body, property);
      }
    }
  }
}

void read_plain_vertices(PlyBinaryBody& body, const PlyElement& element, IndexedMesh& mesh) {
  check_length(body, element);
  const std::size_t size = element.count * sizeof(Point);
  mesh.positions.resize(element.count);
  if (size > 0) std::memcpy(mesh.positions.data()->data(), body.rest().data(), size);
  body.skip(size);
}

// Reads triangles as long as they have the layout that this program writes; returns their number.
std::uint64_t read_plain_triangles(PlyBinaryBody& body, const PlyElement& element,
                                   IndexedMesh& mesh) {
  const PlyProperty& only = element.properties[0];
  if (body.is_swapped() || element.properties.size() != 1 ||
      (only.count_type != PlyScalar::UInt8 && only.count_type != PlyScalar::Int8) ||
      (only.type != PlyScalar::UInt32 && only.type != PlyScalar::Int32)) {
    return 0;
  }
  const std::uint64_t most = std::min<std::uint64_t>(element.count, body.rest().size() / face_size);
  const char* bytes = body.rest().data();
  mesh.triangles.reserve(most);
  std::uint64_t count = 0;
  for (; count < most && bytes[0] == 3; ++count, bytes += face_size) {
    std::array<std::uint32_t, 3> corners;
    std::memcpy(corners.data(), bytes + 1, sizeof corners);
    mesh.triangles.push_back(corners);
  }
  body.skip(count * face_size);
  return count;
}

template <class Body>
void read_faces(Body& body, const PlyElement& element, IndexedMesh& mesh) {
  const PlyProperty* corners = nullptr;
  for (const PlyProperty& property : element.properties) {
    const bool is_named = property.name == "vertex_indices" || property.name == "vertex_index";
    if (!property.is_list() || !is_named) continue;
    if (corners != nullptr) {
      throw UnreadableInput(body.location() + ": faces have two lists of corners; write one");
    }
    corners = &property;
  }
  if (corners == nullptr) {
    throw UnreadableInput(body.location() +
                          ": faces need a list vertex_indices; write the mesh again");
  }
  check_length(body, element);
  std::uint64_t face = 0;
  if constexpr (std::is_same_v<Body, PlyBinaryBody>) {
    face = read_plain_triangles(body, element, mesh);
  }
  std::vector<std::uint32_t> polygon;
  for (; face < element.count; ++face) {
    for (const PlyProperty& property : element.properties) {
      if (&property != corners) {
        skip_property(body, property);
        continue;
      }
      const std::uint32_t count = take_whole(body, *property.count_type);
      if (count < 3) {
        throw UnreadableInput(body.location() + ": face " + std::to_string(face) + " has " +
                              std::to_string(count) + " corners; remove it");
      }
      polygon.clear();
      for (std::uint32_t i = 0; i < count; ++i) polygon.push_back(take_whole(body, property.type));
      append_fan(mesh, polygon);
    }
  }
}

template <class Body>
void skip_element(Body& body, const PlyElement& element) {
  if (element.properties.empty()) return;
  check_length(body, element);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) skip_property(body, property);
  }
}

void check_corners(const IndexedMesh& mesh, const std::string& source) {
  std::uint32_t highest = 0;
  for (const auto& [a, b, c] : mesh.triangles) highest = std::max({highest, a, b, c});
  if (mesh.triangles.empty() || highest < mesh.positions.size()) return;
  throw UnreadableInput(source + ": a face has corner " + std::to_string(highest) +
                        " but there are only " + std::to_string(mesh.positions.size()) +
                        " vertices; write the mesh again");
}

template <class Body>
IndexedMesh read_body(Body body, const PlyHeader& header, const std::string& source) {
  IndexedMesh mesh;
  bool has_vertices = false;
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "tristrips") {
      throw UnreadableInput(source + ": triangle strips are not read; write faces instead");
    }
    if ((element.name == "vertex" && has_vertices) || (element.name == "face" && has_faces)) {
      throw UnreadableInput(source + ": has two elements " + quoted(element.name) +
                            "; write one mesh");
    }
    if (element.name == "vertex") {
      has_vertices = true;
      if constexpr (std::is_same_v<Body, PlyBinaryBody>) {
        if (is_plain(body, element)) {
          read_plain_vertices(body, element, mesh);
          continue;
        }
      }
      read_vertices(body, element, mesh);
    } else if (element.name == "face") {
      has_faces = true;
      read_faces(body, element, mesh);
    } else {
      skip_element(body, element);
    }
  }
  if (!has_vertices) throw UnreadableInput(source + ": has no vertices; is it a mesh?");
  if (body.has_more()) {
    throw UnreadableInput(body.location() +
                          ": the file goes on behind the last element that its header counts; " +
                          "write it again");
  }
  check_finite(mesh, source);
  check_corners(mesh, source);
  return mesh;
}

}  // namespace

IndexedMesh parse_ply(std::string_view bytes, const std::string& source) {
  const PlyHeader header = parse_ply_header(bytes, source);
  if (header.encoding == PlyEncoding::Ascii) {
    return read_body(PlyAsciiBody(header, source), header, source);
  }
  return read_body(PlyBinaryBody(header, source), header, source);
}

}  // namespace morskin::geometry::mesh_formats
