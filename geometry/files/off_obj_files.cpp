// OFF and OBJ: meshes as lines of text.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

constexpr std::size_t max_vertices = std::numeric_limits<std::uint32_t>::max();

// Moves to the next OFF line with content and returns it without its comment; "" at the end.
std::string_view next_off_line(TextLines& lines) {
  while (lines.advance()) {
    const std::string_view line = lines.line();
    const std::string_view content = trimmed(line.substr(0, line.find('#')));
    if (!content.empty()) return content;
  }
  return {};
}

std::size_t take_count(std::string_view& fields, std::string_view what, const TextLines& lines) {
  const std::string_view field = take_field(fields);
  const std::optional<std::int64_t> count = parse_integer(field);
  if (!count || *count < 0) {
    lines.fail("expected " + std::string(what) + ", found " + quoted(field) +
               "; write the mesh again");
  }
  return static_cast<std::size_t>(*count);
}

std::uint32_t off_corner(std::string_view field, std::size_t vertices, const TextLines& lines) {
  const std::optional<std::int64_t> index = parse_integer(field);
  if (!index) {
    lines.fail("corner " + quoted(field) + " is not a whole number; write the mesh again");
  }
  if (*index < 0 || static_cast<std::size_t>(*index) >= vertices) {
    lines.fail("corner " + quoted(field) + " does not exist, there are " +
               std::to_string(vertices) + " vertices from 0 on; write the mesh again");
  }
  return static_cast<std::uint32_t>(*index);
}

// One corner of an OBJ face, "v", "v/vt", "v//vn" or "v/vt/vn"; a negative v counts back from the
// last vertex so far. Positive ones are checked at the end of the file.
std::uint32_t obj_corner(std::string_view field, std::size_t vertices, const TextLines& lines) {
  const std::optional<std::int64_t> number = parse_integer(field.substr(0, field.find('/')));
  const auto known = static_cast<std::int64_t>(vertices);
  if (!number || *number == 0 || *number < -known ||
      *number > static_cast<std::int64_t>(max_vertices)) {
    lines.fail("corner " + quoted(field) + " names no vertex; write the mesh again");
  }
  return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : known + *number);
}

// Weights are of rational curves, which are not read; some programs divide a vertex by its own.
void check_obj_weight(std::string_view fields, const TextLines& lines) {
  const std::string_view weight = take_field(fields);
  const bool is_last = take_field(fields).empty();  // else colours
  if (weight.empty() || !is_last || parse_double(weight) == 1.0) return;
  lines.fail("a vertex has the weight " + quoted(weight) +
             ", which programs read in two ways; write it without");
}

/// The line with those that continue it, joined in `buffer` if there are any. Programs agree on it
/// in vertices and faces only: the line after a comment or a name may be a face to some.
std::string_view joined_line(TextLines& lines, std::string& buffer) {
  std::string_view line = lines.line();
  if (!line.ends_with('\\')) return line;
  std::string_view fields = line;
  const std::string_view word = take_field(fields);
  const bool is_read = word == "v" || word == "f";
  buffer.assign(line.substr(0, line.size() - 1));
  while (line.ends_with('\\') && !lines.rest().empty()) {
    if (!is_read || line.find('#') != std::string_view::npos) {
      lines.fail(
          "a backslash ends a comment, or a line that is no vertex or face, and only some programs "
          "join it with the next; take it out");
    }
    lines.advance();
    line = lines.line();
    buffer.append(line.substr(0, line.size() - (line.ends_with('\\') ? 1 : 0)));
  }
  return buffer;
}

}  // namespace

IndexedMesh parse_off(std::string_view bytes, const std::string& source) {
  TextLines lines(bytes, source, LoneReturn::IsRefused);
  std::string_view fields = next_off_line(lines);
  const std::string_view word = take_field(fields);
  if (!word.ends_with("OFF") || word.find_first_of("4n") != std::string_view::npos) {
    lines.fail("expected OFF for points in space, found " + quoted(word) +
               "; write the mesh as OFF");
  }
  if (trimmed(fields).empty()) fields = next_off_line(lines);
  if (fields.find("BINARY") != std::string_view::npos) {
    lines.fail("binary OFF is not read; write the mesh as text OFF or as PLY");
  }
  constexpr std::string_view counts = "the numbers of vertices, faces and edges";
  const std::size_t vertices = take_count(fields, counts, lines);
  const std::size_t faces = take_count(fields, counts, lines);
  if (vertices > max_vertices) lines.fail("too many vertices; at most 2^32 - 1 are read");

  // A vertex needs six bytes of text ("0 0 0\n") and a face eight, which bounds the counts.
  IndexedMesh mesh;
  mesh.positions.reserve(std::min(vertices, bytes.size() / 6 + 1));
  mesh.triangles.reserve(std::min(faces, bytes.size() / 8 + 1));
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    std::string_view line = next_off_line(lines);
    if (line.empty()) {
      lines.fail(
          "the file ends before its last vertex; write it again, each vertex on a line of its own");
    }
    mesh.positions.push_back(take_position(line, lines));
  }
  std::vector<std::uint32_t> polygon;
  for (std::size_t face = 0; face < faces; ++face) {
    std::string_view line = next_off_line(lines);
    if (line.empty()) {
      lines.fail(
          "the file ends before its last face; write it again, each face on a line of its own");
    }
    const std::size_t corners = take_count(line, "the number of a face's corners", lines);
    if (corners < 3) lines.fail("a face needs three corners; remove it");
    polygon.clear();
    for (std::size_t corner = 0; corner < corners; ++corner) {
      polygon.push_back(off_corner(take_field(line), vertices, lines));
    }
    append_fan(mesh, polygon);
  }
  if (!next_off_line(lines).empty()) {
    lines.fail("the file goes on behind the last of its " + std::to_string(faces) +
               " faces; write it again");
  }
  return mesh;
}

IndexedMesh parse_obj(std::string_view bytes, const std::string& source) {
  TextLines lines(bytes, source, LoneReturn::IsRefused);
  IndexedMesh mesh;
  std::vector<std::uint32_t> polygon;
  std::uint32_t last_corner = 0;
  std::string last_corner_location;  // of the face that names it
  bool is_other = false;             // some line was neither vertex nor face nor comment
  std::string joined;                // a line and its continuations
  while (lines.advance()) {
    std::string_view fields = joined_line(lines, joined);
    fields = fields.substr(0, fields.find('#'));
    const std::string_view word = take_field(fields);
    if (word == "v") {
      mesh.positions.push_back(take_position(fields, lines));
      check_obj_weight(fields, lines);
      if (mesh.positions.size() > max_vertices) {
        lines.fail("too many vertices; at most 2^32 - 1 are read");
      }
    } else if (word == "f") {
      polygon.clear();
      for (const std::string_view field : fields_of(fields)) {
        polygon.push_back(obj_corner(field, mesh.positions.size(), lines));
      }
      if (polygon.size() < 3) lines.fail("a face needs three corners; remove it");
      const std::uint32_t highest = *std::ranges::max_element(polygon);
      if (highest > last_corner || last_corner_location.empty()) {
        last_corner = highest;
        last_corner_location = lines.location();
      }
      append_fan(mesh, polygon);
    } else if (!word.empty()) {
      is_other = true;
    }
  }
  if (!mesh.triangles.empty() && last_corner >= mesh.positions.size()) {
    throw UnreadableInput(last_corner_location + ": corner " + std::to_string(last_corner + 1ULL) +
                          " does not exist, there are " + std::to_string(mesh.positions.size()) +
                          " vertices; write the mesh again");
  }
  if (mesh.positions.empty() && is_other) {
    throw UnreadableInput(source + ": holds no vertex; is it an OBJ file?");
  }
  return mesh;
}

std::string off(const IndexedMesh& mesh, const Provenance& provenance) {
  std::string text = "OFF\n";
  text.reserve(64 * mesh.positions.size() + 24 * mesh.triangles.size() + 64);
  append_number(text, std::uint64_t{mesh.positions.size()});
  text += ' ';
  append_number(text, std::uint64_t{mesh.triangles.size()});
  text += " 0\n";
  for (const Point& position : mesh.positions) append_position(text, position);
  for (const auto& triangle : mesh.triangles) {
    text += '3';
    append_corners(text, triangle);
  }
  return text + provenance_lines(provenance, "# ");
}

std::string obj(const IndexedMesh& mesh, const Provenance& provenance) {
  std::string text = "# Angstrom\n" + provenance_lines(provenance, "# ");
  text.reserve(64 * mesh.positions.size() + 24 * mesh.triangles.size() + 64);
  for (const Point& position : mesh.positions) {
    text += "v ";
    append_position(text, position);
  }
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    append_corners(text, triangle, 1);
  }
  return text;
}

}  // namespace morskin::geometry::mesh_formats
