// Reads VTU as this program and others write it by default: one piece, arrays inline, as base64
// without compression or as text. Triangles have three nodes, or six where they are curved.

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/base64.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"
#include "geometry/files/triangle_collector.h"
#include "geometry/files/vtu_grid.h"
#include "geometry/files/xml_tags.h"

namespace morskin::geometry::mesh_formats {
namespace {

[[noreturn]] void fail(const std::string& source, const std::string& what) {
  throw UnreadableInput(source + ": " + what);
}

[[noreturn]] void fail_for_damage(const std::string& source) {
  fail(source, "has an array that is damaged; write it again");
}

template <class Number>
std::vector<double> numbers_of(std::string_view bytes, const std::string& source) {
  if (bytes.size() % sizeof(Number) != 0) fail_for_damage(source);
  std::vector<double> result(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < result.size(); ++i) {
    Number number;
    std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
    result[i] = static_cast<double>(number);
  }
  return result;
}

/// Reads the arrays of one file.
class Reader {
 public:
  explicit Reader(std::string source) : source_(std::move(source)) {}

  void take(const XmlTag& tag) {
    // What may hold tags that other readers do not see: declarations, CDATA, instructions.
    if (tag.name.starts_with('!') || (tag.name.starts_with('?') && tag.name != "?xml")) {
      fail(source_, "holds " + quoted(tag.name) + ", which is not read; write it without");
    }
    if (tag.name == "VTKFile") check_header(tag);
    if (tag.name == "Piece") take_counts(tag);
    if (tag.name == "Points" || tag.name == "Cells" || tag.name == "FieldData") section_ = tag.name;
    if (tag.name.starts_with('/') && tag.name != "/DataArray") section_ = {};
    if (tag.name != "DataArray") return;
    if (section_ == "Points") {
      if (std::exchange(has_points_, true)) {
        fail(source_, "has several arrays of points; write one mesh");
      }
      points_ = array(tag);
    }
    if (section_ == "Cells" && !cells_.emplace(value(tag, "Name"), array(tag)).second) {
      fail(source_,
           "has several arrays of cells called " + quoted(value(tag, "Name")) + "; write one mesh");
    }
    if (section_ == "FieldData") take_field_data(tag);
  }

  ParsedMesh mesh() const {
    TriangleCollector result(positions());
    const std::vector<double>& corners = cell_array("connectivity");
    const std::vector<double>& ends = cell_array("offsets");
    const std::vector<double>& kinds = cell_array("types");
    if (ends.size() != kinds.size()) {
      fail(source_, "has more or fewer cell types than cells; write it again");
    }
    if (!is_count(point_count_, result.point_count()) || !is_count(cell_count_, ends.size())) {
      fail(source_, "has more or fewer points or cells than it says; write it again");
    }
    double start = 0;
    for (std::size_t cell = 0; cell < ends.size(); ++cell) {
      const std::size_t nodes = nodes_of(kinds[cell]);
      const double end = ends[cell];
      if (end != start + static_cast<double>(nodes) ||
          !(end <= static_cast<double>(corners.size()))) {
        fail(source_,
             "cell " + std::to_string(cell) + " has not the corners of its type; write it again");
      }
      std::array<std::uint32_t, 6> at{};
      for (std::size_t k = 0; k < nodes; ++k) {
        at[k] = index(corners[static_cast<std::size_t>(start) + k], result.point_count());
      }
      const TriangleCorners at_corners{at[0], at[1], at[2]};
      nodes == 3 ? result.add(at_corners) : result.add(at_corners, {at[3], at[4], at[5]});
      start = end;
    }
    return std::move(result).take(source_);
  }

  const Provenance& provenance() const { return provenance_; }

 private:
  void check_header(const XmlTag& tag) {
    if (value(tag, "type") != "UnstructuredGrid") {
      fail(source_, "is no unstructured grid; write it as one");
    }
    if (tag.attributes.contains("compressor")) {
      fail(source_, "is compressed; write it without compression");
    }
    if (tag.attributes.contains("byte_order") && value(tag, "byte_order") != "LittleEndian") {
      fail(source_, "is big-endian; write it as LittleEndian");
    }
    is_wide_ = tag.attributes.contains("header_type") && value(tag, "header_type") == "UInt64";
  }
  void take_counts(const XmlTag& tag) {
    if (++pieces_ > 1) fail(source_, "has several pieces; write one mesh");
    point_count_ = parse_integer(value(tag, "NumberOfPoints"));
    cell_count_ = parse_integer(value(tag, "NumberOfCells"));
  }
  static bool is_count(std::optional<std::int64_t> told, std::size_t count) {
    return !told || *told == static_cast<std::int64_t>(count);
  }
  /// A number, or a text by its bytes.
  void take_field_data(const XmlTag& tag) {
    const std::vector<double> numbers = array(tag);
    std::string text;
    if (value(tag, "type") == "UInt8") {
      for (const double byte : numbers) {
        text += byte >= 0 && byte < 128 ? static_cast<char>(byte) : '?';
      }
    } else if (numbers.size() == 1) {
      append_number(text, numbers[0]);
    }
    take_entry(provenance_, std::string(value(tag, "Name")) + ' ' + text);
  }
  static std::string_view value(const XmlTag& tag, std::string_view name) {
    const auto found = tag.attributes.find(name);
    return found == tag.attributes.end() ? std::string_view() : found->second;
  }

  std::vector<double> array(const XmlTag& tag) const {
    const std::string_view format = value(tag, "format");
    if (format == "ascii") return ascii_array(tag);
    if (format != "binary") fail(source_, "has arrays that are not inline; write it as binary");
    const std::optional<std::string> bytes = from_base64(trimmed(tag.text));
    const std::size_t head = is_wide_ ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
    if (!bytes || bytes->size() < head) fail_for_damage(source_);
    std::uint64_t size = 0;
    std::memcpy(&size, bytes->data(), head);
    if (size != bytes->size() - head) fail_for_damage(source_);
    const std::string_view numbers = std::string_view(*bytes).substr(head);
    const std::string_view type = value(tag, "type");
    if (type == "Float64") return numbers_of<double>(numbers, source_);
    if (type == "Float32") return numbers_of<float>(numbers, source_);
    if (type == "Int64" || type == "UInt64") return numbers_of<std::int64_t>(numbers, source_);
    if (type == "Int32") return numbers_of<std::int32_t>(numbers, source_);
    if (type == "UInt32") return numbers_of<std::uint32_t>(numbers, source_);
    if (type == "UInt8") return numbers_of<std::uint8_t>(numbers, source_);
    fail(source_, "has numbers of the type " + quoted(type) +
                      ", which are not read; write Float64 and Int64");
  }
  std::vector<double> ascii_array(const XmlTag& tag) const {
    std::vector<double> numbers;
    const std::string_view type = value(tag, "type");
    const bool is_single = type == "Float32";
    // VTK keeps the last eight bits of more.
    const double largest = type == "Int8" || type == "UInt8" ? 255 : DBL_MAX;
    std::string_view rest = tag.text;
    for (std::string_view field = take_field(rest); !field.empty(); field = take_field(rest)) {
      const std::optional<double> number = parse_double(field);
      if (!number || !(std::abs(*number) <= largest)) {
        fail(source_, "has " + quoted(field) + " in the place of a number; write it again");
      }
      numbers.push_back(is_single ? in_single_precision(*number) : *number);
    }
    return numbers;
  }

  std::vector<Point> positions() const {
    if (points_.size() % 3 != 0) {
      fail(source_, "has points without three coordinates; write it again");
    }
    if (points_.size() / 3 > std::numeric_limits<std::uint32_t>::max()) {
      fail(source_, "has too many points; at most 2^32 - 1 are read");
    }
    std::vector<Point> points;
    for (std::size_t i = 0; i < points_.size(); i += 3) {
      points.emplace_back(points_[i], points_[i + 1], points_[i + 2]);
      if (!points.back().allFinite()) {
        fail(source_, "has a coordinate that is not finite; remove it");
      }
    }
    return points;
  }
  const std::vector<double>& cell_array(const std::string& name) const {
    const auto found = cells_.find(name);
    if (found == cells_.end()) {
      fail(source_, "has no array of cells called " + name + "; write it again");
    }
    return found->second;
  }
  std::size_t nodes_of(double kind) const {
    if (kind == static_cast<double>(VtuCell::Triangle)) return 3;
    if (kind == static_cast<double>(VtuCell::QuadraticTriangle)) return 6;
    fail(source_, "has cells that are no triangles; write triangles, of type 5 or 22");
  }
  std::uint32_t index(double corner, std::size_t points) const {
    if (!(corner >= 0 && corner < static_cast<double>(points)) || corner != std::floor(corner)) {
      fail(source_, "has a corner that does not exist; write it again");
    }
    return static_cast<std::uint32_t>(corner);
  }

  std::string source_;
  std::string_view section_;
  bool is_wide_ = false;
  int pieces_ = 0;
  std::optional<std::int64_t> point_count_, cell_count_;  ///< if the piece says them
  bool has_points_ = false;
  std::vector<double> points_;
  std::map<std::string, std::vector<double>> cells_;
  Provenance provenance_;
};

}  // namespace

ParsedMesh parse_vtu(std::string_view bytes, const std::string& source) {
  Reader reader(source);
  const std::string complaint = for_each_tag(bytes, [&](const XmlTag& tag) { reader.take(tag); });
  if (!complaint.empty()) fail(source, complaint + "; write it again");
  return reader.mesh();
}

Provenance vtu_provenance(std::string_view bytes) {
  const std::size_t end = bytes.find("</FieldData>");
  if (end == bytes.npos) return {};
  Reader reader("");
  try {
    for_each_tag(bytes.substr(0, end), [&](const XmlTag& tag) { reader.take(tag); });
  } catch (const UnreadableInput&) {  // what is damaged says nothing
  }
  return reader.provenance();
}

}  // namespace morskin::geometry::mesh_formats
