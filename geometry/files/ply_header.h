#pragma once

// Inside mesh_files: the header of a PLY file.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morskin::geometry::mesh_formats {

constexpr std::size_t face_size = 13;  ///< in our files: one byte 3, three 32-bit corners

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyScalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

/// Bytes of a number in a binary body.
std::size_t size_of(PlyScalar type);

struct PlyProperty {
  std::string name;
  PlyScalar type;
  std::optional<PlyScalar> count_type;  ///< of a list's length; absent if this is no list

  bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
  std::string name;
  std::uint64_t count;  ///< as claimed, unchecked
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding;
  std::vector<PlyElement> elements;
  std::string_view body;   ///< the bytes after the header
  std::size_t line_count;  ///< of the header
};

/// @throws UnreadableInput
PlyHeader parse_ply_header(std::string_view bytes, const std::string& source);

}  // namespace morskin::geometry::mesh_formats
