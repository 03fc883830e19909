#pragma once

// Inside mesh_files: numbers from the binary or ASCII body of a PLY file. Both readers know the
// bytes left, so that counts in the header can be checked.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/ply_header.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {

static_assert(std::endian::native == std::endian::little);

/// The number at the front of `bytes`, in this machine's byte order or swapped.
template <class Number>
double number_at(const char* bytes, bool is_swapped) {
  char copy[sizeof(Number)];
  std::memcpy(copy, bytes, sizeof copy);
  if (is_swapped) std::reverse(copy, copy + sizeof copy);
  Number number;
  std::memcpy(&number, copy, sizeof number);
  return static_cast<double>(number);
}

/// Whether a type can hold a number; floats can, rounded.
inline bool holds(PlyScalar type, double value) {
  const auto is_whole_in = [&](auto some) {
    using Limits = std::numeric_limits<decltype(some)>;
    return value >= Limits::min() && value <= Limits::max() && value == std::floor(value);
  };
  switch (type) {
    case PlyScalar::Int8:
      return is_whole_in(std::int8_t{});
    case PlyScalar::UInt8:
      return is_whole_in(std::uint8_t{});
    case PlyScalar::Int16:
      return is_whole_in(std::int16_t{});
    case PlyScalar::UInt16:
      return is_whole_in(std::uint16_t{});
    case PlyScalar::Int32:
      return is_whole_in(std::int32_t{});
    case PlyScalar::UInt32:
      return is_whole_in(std::uint32_t{});
    default:
      return true;
  }
}

/// Numbers as bytes.
class PlyBinaryBody {
 public:
  PlyBinaryBody(const PlyHeader& header, std::string source)
      : rest_(header.body),
        whole_size_(header.body.size()),
        is_swapped_(header.encoding == PlyEncoding::BigEndian),
        source_(std::move(source)) {}

  bool is_swapped() const { return is_swapped_; }
  std::string_view rest() const { return rest_; }
  std::size_t min_size(PlyScalar type) const { return size_of(type); }
  std::string location() const {
    return source_ + ": byte " + std::to_string(whole_size_ - rest_.size()) + " of the body";
  }

  /// Whether more is left than what files are padded with.
  bool has_more() const {
    constexpr std::string_view padding("\0 \t\r\n", 5);
    return rest_.find_first_not_of(padding) != std::string_view::npos;
  }

  void skip(std::size_t size) {
    if (size > rest_.size())
      throw UnreadableInput(location() + ": the file ends too early; write it again");
    rest_.remove_prefix(size);
  }

  double take(PlyScalar type) {
    const char* at = rest_.data();
    skip(size_of(type));
    switch (type) {
      case PlyScalar::Int8:
        return number_at<signed char>(at, is_swapped_);
      case PlyScalar::UInt8:
        return number_at<unsigned char>(at, is_swapped_);
      case PlyScalar::Int16:
        return number_at<std::int16_t>(at, is_swapped_);
      case PlyScalar::UInt16:
        return number_at<std::uint16_t>(at, is_swapped_);
      case PlyScalar::Int32:
        return number_at<std::int32_t>(at, is_swapped_);
      case PlyScalar::UInt32:
        return number_at<std::uint32_t>(at, is_swapped_);
      case PlyScalar::Float:
        return number_at<float>(at, is_swapped_);
      case PlyScalar::Double:
        return number_at<double>(at, is_swapped_);
    }
    return 0;
  }

 private:
  std::string_view rest_;
  std::size_t whole_size_;
  bool is_swapped_;
  std::string source_;
};

/// Numbers as words.
class PlyAsciiBody {
 public:
  PlyAsciiBody(const PlyHeader& header, std::string source)
      : lines_(header.body, std::move(source), LoneReturn::IsRefused, header.line_count) {}

  std::string_view rest() const { return lines_.rest(); }
  std::size_t min_size(PlyScalar) const { return 1; }
  std::string location() const { return lines_.location(); }
  bool has_more() const { return !trimmed(fields_).empty() || !trimmed(lines_.rest()).empty(); }

  double take(PlyScalar type) {
    std::string_view field = take_field(fields_);
    while (field.empty()) {
      if (!lines_.advance()) lines_.fail("the file ends too early; write it again");
      fields_ = lines_.line();
      field = take_field(fields_);
    }
    const std::optional<double> value = parse_double(field);
    if (!value) lines_.fail(quoted(field) + " is no number; write the mesh again");
    if (!holds(type, *value)) {
      lines_.fail(quoted(field) + " is no number of its property's type; write the mesh again");
    }
    return type == PlyScalar::Float ? in_single_precision(*value) : *value;
  }

 private:
  TextLines lines_;
  std::string_view fields_;  // what is left of the current line
};

}  // namespace morskin::geometry::mesh_formats
