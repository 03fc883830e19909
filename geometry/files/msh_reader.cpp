// Reads Gmsh's MSH 4.1 as text: triangles of three nodes, or of six where they are curved. Points
// and lines are skipped, as are sections other than nodes and elements.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"
#include "geometry/files/triangle_collector.h"

namespace morskin::geometry::mesh_formats {
namespace {

// Gmsh's own numbers.
constexpr std::int64_t triangle = 2, second_order_triangle = 9;
constexpr std::array<std::int64_t, 6> points_and_lines{15, 1, 8, 26, 27, 28};

std::string_view next_line(TextLines& lines) {
  if (!lines.advance()) lines.fail("the file ends too early; write it again");
  return lines.line();
}

std::int64_t take_integer(std::string_view& fields, const TextLines& lines) {
  const std::string_view field = take_field(fields);
  const std::optional<std::int64_t> number = parse_integer(field);
  if (!number || *number < 0) {
    lines.fail("expected a whole number, found " + quoted(field) + "; write the mesh again");
  }
  return *number;
}

/// Numbers of a line, of which there must be so many at least.
std::vector<std::int64_t> integers(TextLines& lines, std::size_t count) {
  std::string_view fields = next_line(lines);
  std::vector<std::int64_t> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(take_integer(fields, lines));
  return result;
}

/// Goes on to the end of a section, over what other readers skip as well.
void skip_to_end(TextLines& lines, std::string_view section) {
  const std::string end = "$End" + std::string(section.substr(1));
  while (trimmed(next_line(lines)) != end) {
  }
}

/// @param told  how many the section says that there are
void check_count(std::int64_t told, std::int64_t found, const std::string& what,
                 const TextLines& lines) {
  if (told == found) return;
  lines.fail("there are " + std::to_string(found) + " " + what + " where " + std::to_string(told) +
             " were announced; write the mesh again");
}

/// Points with Gmsh's tags for them.
struct Nodes {
  std::vector<Point> points;
  std::vector<std::pair<std::int64_t, std::uint32_t>> by_tag;  ///< ascending, with the index

  /// As a rule tags follow each other; others are searched for. A file could choose them so that a
  /// hash table would have them all in one place.
  std::optional<std::uint32_t> index(std::int64_t tag) const {
    if (by_tag.empty() || tag < by_tag.front().first) return std::nullopt;
    const auto place = static_cast<std::size_t>(tag - by_tag.front().first);
    if (place < by_tag.size() && by_tag[place].first == tag) return by_tag[place].second;
    const auto found = std::ranges::lower_bound(by_tag, std::pair(tag, std::uint32_t{0}));
    if (found == by_tag.end() || found->first != tag) return std::nullopt;
    return found->second;
  }
};

Nodes parse_nodes(TextLines& lines) {
  Nodes nodes;
  const std::vector<std::int64_t> told = integers(lines, 4);  // blocks, nodes, and their tags
  for (std::int64_t block = 0; block < told[0]; ++block) {
    const std::int64_t count = integers(lines, 4)[3];
    const std::size_t first = nodes.points.size();
    for (std::int64_t i = 0; i < count; ++i) {
      const auto next = static_cast<std::uint32_t>(first + static_cast<std::size_t>(i));
      nodes.by_tag.emplace_back(integers(lines, 1)[0], next);
    }
    for (std::int64_t i = 0; i < count; ++i) {
      std::string_view fields = next_line(lines);
      nodes.points.push_back(take_position(fields, lines));
    }
  }
  check_count(told[1], static_cast<std::int64_t>(nodes.points.size()), "nodes", lines);
  if (!std::ranges::is_sorted(nodes.by_tag)) std::ranges::sort(nodes.by_tag);
  const auto twice = std::ranges::adjacent_find(
      nodes.by_tag, [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != nodes.by_tag.end()) {
    lines.fail("two nodes have the tag " + std::to_string(twice->first) + "; write the mesh again");
  }
  return nodes;
}

std::uint32_t take_node(std::string_view& fields, const Nodes& nodes, const TextLines& lines) {
  const std::optional<std::uint32_t> found = nodes.index(take_integer(fields, lines));
  if (!found) lines.fail("a node does not exist; write the mesh again");
  return *found;
}

void parse_elements(TextLines& lines, const Nodes& nodes, TriangleCollector& mesh) {
  const std::vector<std::int64_t> told = integers(lines, 4);  // blocks, elements, and their tags
  std::int64_t found = 0;
  for (std::int64_t block = 0; block < told[0]; ++block) {
    const std::vector<std::int64_t> head = integers(lines, 4);
    const bool is_curved = head[2] == second_order_triangle;
    const bool is_read = is_curved || head[2] == triangle;
    if (!is_read && std::ranges::find(points_and_lines, head[2]) == points_and_lines.end()) {
      lines.fail("elements of type " + std::to_string(head[2]) +
                 " are not read; write triangles, of type 2 or 9");
    }
    // Some programs go by the type, some by the dimension.
    if (is_read && head[0] != 2) {
      lines.fail("triangles have the dimension " + std::to_string(head[0]) +
                 "; write them as a surface, of dimension 2");
    }
    for (std::int64_t i = 0; i < head[3]; ++i, ++found) {
      std::string_view fields = next_line(lines);
      if (!is_read) continue;
      take_integer(fields, lines);  // its tag
      const auto take_three = [&] {
        TriangleCorners three;
        for (std::uint32_t& node : three) node = take_node(fields, nodes, lines);
        return three;
      };
      const TriangleCorners corners = take_three();
      is_curved ? mesh.add(corners, take_three()) : mesh.add(corners);
    }
  }
  check_count(told[1], found, "elements", lines);
}

}  // namespace

ParsedMesh parse_msh(std::string_view bytes, const std::string& source) {
  TextLines lines(bytes, source, LoneReturn::IsRefused);
  std::optional<Nodes> nodes;
  std::optional<TriangleCollector> mesh;
  bool has_elements = false;
  while (lines.advance()) {
    const std::string_view section = trimmed(lines.line());
    if (!section.starts_with('$')) continue;
    if (section == "$MeshFormat") {
      const std::string_view format = trimmed(next_line(lines));
      if (!format.starts_with("4.1 0 ")) {
        lines.fail("only MSH 4.1 as text is read, not " + quoted(format) +
                   "; write the mesh as that");
      }
    } else if (section == "$Nodes") {
      if (nodes) lines.fail("there are two sections of nodes; write one mesh");
      nodes = parse_nodes(lines);
      mesh.emplace(nodes->points);
    } else if (section == "$Elements") {
      if (!mesh) lines.fail("elements come before the nodes; write the mesh again");
      if (std::exchange(has_elements, true)) {
        lines.fail("there are two sections of elements; write one mesh");
      }
      parse_elements(lines, *nodes, *mesh);
    }
    skip_to_end(lines, section);
  }
  if (!mesh) lines.fail("there are no nodes; write the mesh again");
  if (!has_elements) lines.fail("there are no elements; write the mesh again");
  return std::move(*mesh).take(source);
}

}  // namespace morskin::geometry::mesh_formats
