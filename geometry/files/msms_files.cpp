// MSMS: the vertices in one text file, the triangles in another. Both begin with comment lines and
// a line of counts (vertices or faces, spheres, density, probe radius), which may be left out.
//
//   .vert   x y z  nx ny nz  analytic face  closest sphere  kind  [atom]
//   .face   a b c  kind  analytic face                    corners are counted from 1

#include <array>
#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

constexpr std::size_t fields_of_counts = 4;  // a line of data has at least five

std::size_t field_count(std::string_view line) {
  std::size_t count = 0;
  while (!take_field(line).empty()) ++count;
  return count;
}

// Calls take(fields) for each line of data, and compares their number with the line of counts.
template <class Take>
void for_each_row(TextLines& lines, const std::string& what, Take take) {
  std::optional<std::int64_t> promised;
  std::size_t rows = 0;
  bool is_first = true;
  while (lines.advance()) {
    std::string_view fields = trimmed(lines.line());
    if (fields.empty() || fields[0] == '#') continue;
    if (std::exchange(is_first, false) && field_count(fields) <= fields_of_counts) {
      promised = parse_integer(take_field(fields));
      if (!promised) lines.fail("expected the number of " + what + "; write the mesh again");
      continue;
    }
    take(fields);
    ++rows;
  }
  if (promised && *promised != static_cast<std::int64_t>(rows)) {
    throw UnreadableInput(lines.source() + ": promises " + std::to_string(*promised) + " " + what +
                          " and holds " + std::to_string(rows) + "; write it again");
  }
}

// Always there, for the line of counts must be the third.
std::string first_line(const MeshAttributes& attributes) {
  const std::string line = provenance_line(attributes.provenance);
  return line.empty() ? "# Angstrom\n" : line;
}

}  // namespace

IndexedMesh parse_msms(const MsmsFile& vertices, const MsmsFile& faces) {
  IndexedMesh mesh;
  TextLines vertex_lines(vertices.bytes, vertices.source, LoneReturn::IsRefused);
  for_each_row(vertex_lines, "vertices", [&](std::string_view fields) {
    if (mesh.positions.size() == std::numeric_limits<std::uint32_t>::max()) {
      vertex_lines.fail("too many vertices; at most 2^32 - 1 are read");
    }
    mesh.positions.push_back(take_position(fields, vertex_lines));
  });
  TextLines face_lines(faces.bytes, faces.source, LoneReturn::IsRefused);
  for_each_row(face_lines, "faces", [&](std::string_view fields) {
    std::array<std::uint32_t, 3> triangle;
    for (std::uint32_t& corner : triangle) {
      const std::string_view field = take_field(fields);
      const std::optional<std::int64_t> number = parse_integer(field);
      if (!number || *number < 1 || static_cast<std::size_t>(*number) > mesh.positions.size()) {
        face_lines.fail("corner " + quoted(field) + " does not exist, there are " +
                        std::to_string(mesh.positions.size()) +
                        " vertices from 1 on; write the mesh again");
      }
      corner = static_cast<std::uint32_t>(*number - 1);
    }
    mesh.triangles.push_back(triangle);
  });
  return mesh;
}

std::string fixed(double number, int decimals) {
  std::array<char, 400> digits;  // the largest double has 309 before its point
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                          std::chars_format::fixed, decimals);
  return {digits.data(), end};
}

namespace {

/// Appends rows as MSMS does, in columns, or with one blank between numbers of any length.
class Rows {
 public:
  Rows(std::string& text, std::optional<int> decimals) : text_(text), decimals_(decimals) {}

  void add(const Vector& vector) {
    for (const double x : vector) {
      // As wide as four digits and a sign before the point.
      if (decimals_) {
        add(fixed(x, *decimals_), static_cast<std::size_t>(*decimals_) + 6);
      } else {
        append_number(text_, x);
        text_ += ' ';
      }
    }
  }
  void add(std::uint64_t number, std::size_t width) {
    if (decimals_) return add(std::to_string(number), width);
    append_number(text_, number);
    text_ += ' ';
  }
  void end() { text_.back() = '\n'; }

 private:
  void add(const std::string& number, std::size_t width) {
    if (number.size() < width) text_.append(width - number.size(), ' ');
    text_ += number + ' ';
  }

  std::string& text_;
  std::optional<int> decimals_;
};

/// The three lines before the rows. Probe radius and density are MSMS's own and mean nothing here.
std::string header(const MeshAttributes& attributes, const std::string& things,
                   const std::string& columns, std::size_t count) {
  return first_line(attributes) + "# " + things + " spheres density probe, then " + columns + "\n" +
         std::to_string(count) + " " + std::to_string(attributes.msms.sphere_count) + " 0 0\n";
}

// MSMS's own.
constexpr std::size_t index_width = 7, kind_width = 2;

}  // namespace

std::string msms_vertices(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  const MsmsColumns& columns = attributes.msms;
  std::string text =
      header(attributes, "vertices", "x y z nx ny nz 0 sphere kind", mesh.positions.size());
  text.reserve(text.size() + 130 * mesh.positions.size());
  Rows rows(text, columns.decimals);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    rows.add(mesh.positions[v]);
    rows.add(attributes.normals[v]);
    rows.add(0, index_width);
    rows.add(std::uint64_t{columns.spheres[v]} + 1, index_width);
    rows.add(columns.kinds[v], kind_width);
    rows.end();
  }
  return text;
}

std::string msms_faces(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  const MsmsColumns& columns = attributes.msms;
  std::string text = header(attributes, "faces", "a b c kind 1", mesh.triangles.size());
  text.reserve(text.size() + 30 * mesh.triangles.size());
  Rows rows(text, columns.decimals);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t corner : mesh.triangles[t]) {
      rows.add(std::uint64_t{corner} + 1, index_width);
    }
    rows.add(columns.face_kinds[t], kind_width);
    rows.add(1, index_width);
    rows.end();
  }
  return text;
}

}  // namespace morskin::geometry::mesh_formats
