// Arrays are inline base64 of a 64-bit byte count followed by the little-endian numbers.

#include "geometry/files/vtu_grid.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>

#include "geometry/files/base64.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class Number>
void append_array(std::string& text, std::string_view attributes,
                  const std::vector<Number>& numbers) {
  const std::uint64_t size = numbers.size() * sizeof(Number);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, numbers.data(), size);
  text += "<DataArray ";
  text += attributes;
  text += " format=\"binary\">";
  append_base64(text, bytes);
  text += "</DataArray>\n";
}

void append_attributes(std::string& text, std::span<const Attribute> attributes) {
  for (const Attribute& a : attributes) {
    std::string described = a.is_whole ? "type=\"Int32\"" : "type=\"Float64\"";
    described += " Name=\"" + a.name + "\" NumberOfComponents=\"";
    append_number(described, std::uint64_t{a.columns.size()});
    described += '"';
    for (std::size_t i = 0; i < a.columns.size() && a.columns.size() > 1; ++i) {
      described += " ComponentName";
      append_number(described, std::uint64_t{i});
      described += "=\"" + a.columns[i] + "\"";
    }
    if (a.is_whole) {
      append_array(text, described, std::vector<std::int32_t>(a.numbers.begin(), a.numbers.end()));
    } else {
      append_array(text, described, a.numbers);
    }
  }
}

// Texts as their bytes, for meshio stops on VTK's own strings.
void append_field_data(std::string& text, std::span<const Provenance::Entry> entries) {
  if (entries.empty()) return;
  text += "<FieldData>\n";
  for (const auto& [key, value, is_number] : entries) {
    const std::optional<double> number = is_number ? parse_double(value) : std::nullopt;
    const std::string named =
        "Name=\"" + key + "\" NumberOfTuples=\"" + std::to_string(number ? 1 : value.size()) + "\"";
    if (number) {
      append_array(text, "type=\"Float64\" " + named, std::vector{*number});
    } else {
      append_array(text, "type=\"UInt8\" " + named,
                   std::vector<std::uint8_t>(value.begin(), value.end()));
    }
  }
  text += "</FieldData>\n";
}

}  // namespace

std::string vtu(const VtuGrid& grid) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * grid.points.size());
  for (const Point& point : grid.points) {
    coordinates.insert(coordinates.end(), point.data(), point.data() + 3);
  }
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  text.reserve(32 * grid.points.size() + 11 * grid.corners.size() + 13 * grid.ends.size() + 8192);
  append_field_data(text, grid.field_data);
  text += "<Piece NumberOfPoints=\"";
  append_number(text, std::uint64_t{grid.points.size()});
  text += "\" NumberOfCells=\"";
  append_number(text, std::uint64_t{grid.ends.size()});
  text += "\">\n";
  if (!grid.point_attributes.empty()) {
    text += "<PointData>\n";
    append_attributes(text, grid.point_attributes);
    text += "</PointData>\n";
  }
  if (!grid.cell_attributes.empty()) {
    text += "<CellData>\n";
    append_attributes(text, grid.cell_attributes);
    text += "</CellData>\n";
  }
  text += "<Points>\n";
  append_array(text, R"(type="Float64" Name="Points" NumberOfComponents="3")", coordinates);
  text += "</Points>\n<Cells>\n";
  append_array(text, R"(type="Int64" Name="connectivity")", grid.corners);
  append_array(text, R"(type="Int64" Name="offsets")", grid.ends);
  append_array(text, R"(type="UInt8" Name="types")", grid.kinds);
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

}  // namespace morskin::geometry
