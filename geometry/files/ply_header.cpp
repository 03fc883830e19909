#include "geometry/files/ply_header.h"

#include <array>
#include <utility>

#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

constexpr std::array<std::pair<std::string_view, PlyScalar>, 16> scalar_names = {{
    {"char", PlyScalar::Int8},
    {"int8", PlyScalar::Int8},
    {"uchar", PlyScalar::UInt8},
    {"uint8", PlyScalar::UInt8},
    {"short", PlyScalar::Int16},
    {"int16", PlyScalar::Int16},
    {"ushort", PlyScalar::UInt16},
    {"uint16", PlyScalar::UInt16},
    {"int", PlyScalar::Int32},
    {"int32", PlyScalar::Int32},
    {"uint", PlyScalar::UInt32},
    {"uint32", PlyScalar::UInt32},
    {"float", PlyScalar::Float},
    {"float32", PlyScalar::Float},
    {"double", PlyScalar::Double},
    {"float64", PlyScalar::Double},
}};

PlyScalar scalar_named(std::string_view name, const TextLines& lines) {
  for (const auto& [known, type] : scalar_names) {
    if (name == known) return type;
  }
  lines.fail(quoted(name) + " is no PLY number type; write the mesh again");
}

PlyEncoding encoding_named(std::string_view name, const TextLines& lines) {
  if (name == "ascii") return PlyEncoding::Ascii;
  if (name == "binary_little_endian") return PlyEncoding::LittleEndian;
  if (name == "binary_big_endian") return PlyEncoding::BigEndian;
  lines.fail(quoted(name) + " is no PLY encoding; write the mesh again");
}

PlyElement take_element(std::string_view fields, const TextLines& lines) {
  PlyElement element{std::string(take_field(fields)), 0, {}};
  const std::string_view count = take_field(fields);
  const std::optional<std::int64_t> number = parse_integer(count);
  if (!number || *number < 0) {
    lines.fail("expected how many elements follow, found " + quoted(count) +
               "; write the mesh again");
  }
  element.count = static_cast<std::uint64_t>(*number);
  return element;
}

PlyProperty take_property(std::string_view fields, const TextLines& lines) {
  std::string_view type = take_field(fields);
  std::optional<PlyScalar> count_type;
  if (type == "list") {
    count_type = scalar_named(take_field(fields), lines);
    if (*count_type == PlyScalar::Float || *count_type == PlyScalar::Double) {
      lines.fail("the length of a list must be a whole number; write the mesh again");
    }
    type = take_field(fields);
  }
  const PlyScalar scalar = scalar_named(type, lines);
  return {std::string(take_field(fields)), scalar, count_type};
}

}  // namespace

std::size_t size_of(PlyScalar type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& source) {
  TextLines lines(bytes, source, LoneReturn::IsRefused);
  std::optional<PlyEncoding> encoding;
  PlyHeader header{};
  while (lines.advance()) {
    std::string_view fields = lines.line();
    const std::string_view word = take_field(fields);
    if (lines.number() == 1) {
      if (word != "ply") lines.fail("is no PLY file; write the mesh again");
    } else if (word == "format") {
      encoding = encoding_named(take_field(fields), lines);
    } else if (word == "element") {
      header.elements.push_back(take_element(fields, lines));
    } else if (word == "property") {
      if (header.elements.empty())
        lines.fail("a property before any element; write the mesh again");
      header.elements.back().properties.push_back(take_property(fields, lines));
    } else if (word == "end_header") {
      if (!encoding) lines.fail("the header names no format; write the mesh again");
      header.encoding = *encoding;
      header.body = lines.rest();
      header.line_count = lines.number();
      return header;
    } else if (!word.empty() && word != "comment" && word != "obj_info") {
      lines.fail(quoted(word) + " is no word of a PLY header; write the mesh again");
    }
  }
  lines.fail("the header does not end; write the mesh again");
}

}  // namespace morskin::geometry::mesh_formats
