#pragma once

// Inside mesh_files: what the header of a PLY file says.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morskin::geometry::mesh_formats {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyScalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

/// How many bytes a number takes in a binary body.
std::size_t size_of(PlyScalar type);

struct PlyProperty {
  std::string name;
  PlyScalar type;
  std::optional<PlyScalar> count_type;  ///< present in lists: of the number that leads the list

  bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count;  ///< as claimed; not yet believed
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
  std::string_view body;   ///< what follows the header
  std::size_t line_count;  ///< of the header
};

/// @throws UnreadableInput
PlyHeader parse_ply_header(std::string_view bytes, const std::string& source);

}  // namespace morskin::geometry::mesh_formats
