// Writes Gmsh's MSH 4.1, as text: one surface of all triangles, nodes and elements counted
// from 1, and a view for each column of numbers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

// Gmsh's own numbers.
constexpr int surface_dimension = 2, surface_tag = 1;
constexpr int triangle_type = 2, second_order_triangle_type = 9;

/// Appends a section, `$Name`, what `body` appends, `$EndName`.
template <class Body>
void append_section(std::string& text, const std::string& name, const Body& body) {
  text += "$" + name + "\n";
  body();
  text += "$End" + name + "\n";
}

void append_count(std::string& text, std::size_t count) {
  append_number(text, std::uint64_t{count});
  text += ' ';
}

std::string surface() {
  return std::to_string(surface_dimension) + " " + std::to_string(surface_tag);
}

/// One block of `count` things with tags from 1 on.
void append_block_counts(std::string& text, std::size_t count) {
  text += "1 ";
  append_count(text, count);
  text += "1 ";
  append_count(text, count);
  text.back() = '\n';
}

void append_surface(std::string& text, const std::vector<Point>& points) {
  Point least = Point::Zero(), most = Point::Zero();
  if (!points.empty()) least = most = points[0];
  for (const Point& p : points) {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  text += "0 0 1 0\n" + std::to_string(surface_tag) + " ";
  append_position(text, least);
  text.back() = ' ';
  append_position(text, most);
  text.back() = ' ';
  text += "0 0\n";
}

void append_nodes(std::string& text, const std::vector<Point>& points) {
  append_block_counts(text, points.size());
  text += surface() + " 0 ";
  append_count(text, points.size());
  text.back() = '\n';
  for (std::size_t v = 1; v <= points.size(); ++v) {
    append_count(text, v);
    text.back() = '\n';
  }
  for (const Point& p : points) append_position(text, p);
}

/// @param type  Gmsh's number for triangles of so many nodes
template <std::size_t Nodes>
void append_elements(std::string& text,
                     const std::vector<std::array<std::uint32_t, Nodes>>& triangles, int type) {
  append_block_counts(text, triangles.size());
  text += surface() + " " + std::to_string(type) + " ";
  append_count(text, triangles.size());
  text.back() = '\n';
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    append_number(text, std::uint64_t{t + 1});
    for (const std::uint32_t node : triangles[t]) {
      text += ' ';
      append_number(text, std::uint64_t{node} + 1);
    }
    text += '\n';
  }
}

/// A view of `width` numbers for each of the attribute's rows, from column `first` on.
void append_view(std::string& text, const Attribute& a, const std::string& name, std::size_t first,
                 std::size_t width) {
  const std::size_t step = a.columns.size(), rows = a.numbers.size() / step;
  // One string, the name; one real number, the time; three integers: time step, width and rows.
  text += "1\n\"" + name + "\"\n1\n0\n3\n0\n" + std::to_string(width) + "\n" +
          std::to_string(rows) + "\n";
  for (std::size_t row = 0; row < rows; ++row) {
    append_number(text, std::uint64_t{row + 1});
    for (std::size_t k = 0; k < width; ++k) {
      text += ' ';
      append_number(text, a.numbers[row * step + first + k]);
    }
    text += '\n';
  }
}

/// Normals make a view of vectors, all else views of single numbers.
void append_views(std::string& text, const std::string& section, const Attribute& a) {
  if (a.columns.size() == 3) {
    append_section(text, section, [&] { append_view(text, a, a.name, 0, 3); });
    return;
  }
  for (std::size_t k = 0; k < a.columns.size(); ++k) {
    append_section(text, section, [&] { append_view(text, a, a.columns[k], k, 1); });
  }
}

template <std::size_t Nodes>
std::string msh(const std::vector<Point>& points,
                const std::vector<std::array<std::uint32_t, Nodes>>& triangles, int type,
                const MeshAttributes& attributes) {
  std::string text;
  text.reserve(72 * points.size() + 32 * triangles.size() + 4096);
  append_section(text, "MeshFormat", [&] { text += "4.1 0 8\n"; });
  append_section(text, "Comments",
                 [&] { text += "Angstrom\n" + provenance_lines(attributes.provenance, ""); });
  append_section(text, "Entities", [&] { append_surface(text, points); });
  append_section(text, "Nodes", [&] { append_nodes(text, points); });
  append_section(text, "Elements", [&] { append_elements(text, triangles, type); });
  for (const Attribute& a : attributes.vertices) append_views(text, "NodeData", a);
  for (const Attribute& a : attributes.triangles) append_views(text, "ElementData", a);
  return text;
}

}  // namespace

std::string msh(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  return msh(mesh.positions, mesh.triangles, triangle_type, attributes);
}

std::string msh(const SecondOrderMesh& mesh, const MeshAttributes& attributes) {
  return msh(mesh.nodes, mesh.triangles, second_order_triangle_type, attributes);
}

}  // namespace morskin::geometry::mesh_formats
