// VTU: the XML form of VTK's unstructured grid. Arrays stand inline as base64 of a 64-bit byte
// count followed by the little-endian numbers.

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <vector>

#include "geometry/mesh_formats.h"
#include "geometry/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view base64_digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr unsigned char triangle_cell_type = 5;  // VTK_TRIANGLE

void append_base64(std::string& text, std::string_view bytes) {
  const auto byte = [&](std::size_t i) {
    return i < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[i])} : 0U;
  };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    const std::array<char, 4> digits = {base64_digits[group >> 18 & 63],
                                        base64_digits[group >> 12 & 63],
                                        i + 1 < bytes.size() ? base64_digits[group >> 6 & 63] : '=',
                                        i + 2 < bytes.size() ? base64_digits[group & 63] : '='};
    text.append(digits.data(), digits.size());
  }
}

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

}  // namespace

std::string vtu(const IndexedMesh& mesh) {
  const std::size_t triangles = mesh.triangles.size();
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.positions.size());
  for (const Point& position : mesh.positions) {
    coordinates.insert(coordinates.end(), position.data(), position.data() + 3);
  }
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> ends;
  corners.reserve(3 * triangles);
  ends.reserve(triangles);
  for (const auto& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
    ends.push_back(static_cast<std::int64_t>(corners.size()));
  }

  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"";
  text.reserve(32 * mesh.positions.size() + 46 * triangles + 1024);
  append_number(text, std::uint64_t{mesh.positions.size()});
  text += "\" NumberOfCells=\"";
  append_number(text, std::uint64_t{triangles});
  text += "\">\n<Points>\n";
  append_array(text, R"(type="Float64" Name="Points" NumberOfComponents="3")", coordinates);
  text += "</Points>\n<Cells>\n";
  append_array(text, R"(type="Int64" Name="connectivity")", corners);
  append_array(text, R"(type="Int64" Name="offsets")", ends);
  append_array(text, R"(type="UInt8" Name="types")",
               std::vector<unsigned char>(triangles, triangle_cell_type));
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

}  // namespace morskin::geometry::mesh_formats
