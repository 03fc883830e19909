#include "app/complex_files.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/function_argument.h"
#include "app/output_names.h"
#include "app/report.h"
#include "app/selection_arguments.h"
#include "geometry/files/text_lines.h"
#include "geometry/files/vtu_grid.h"

namespace morskin::app {
namespace {

using geometry::Point;
using geometry::VtuCell;
using morse::ArcId;
using morse::CriticalId;
using morse::CriticalPoint;
using nlohmann::ordered_json;

template <class Include>
morskin::CriticalCounts counts(const morse::Simplification& simplified, Include include) {
  morskin::CriticalCounts result{};
  for (std::size_t i = 0; i < simplified.complex.points.size(); ++i) {
    result[static_cast<std::size_t>(simplified.complex.points[i].index)] += include(i);
  }
  return result;
}

ordered_json counts_json(const morskin::CriticalCounts& counts, std::size_t arcs,
                         std::size_t regions) {
  ordered_json json = critical_json(counts);
  json["arcs"] = arcs;
  json["regions"] = regions;
  return json;
}

constexpr std::array<std::string_view, 3> simplifications{"raw", "spheres", "persistence"};

ordered_json head(const ComplexReport& report) {
  const MorseArguments& asked = report.arguments;
  const morse::Simplification& left = report.simplified;
  ordered_json json = {{"input", asked.molecule.input.string()}};
  add_model(json, asked.molecule);
  add_selection(json, asked.molecule.selection);
  json["function"] = function_json(report.function);
  json["unit"] = unit_of(report.function);
  json["simplification"] = simplifications[static_cast<std::size_t>(asked.simplify)];
  // JSON has no infinity.
  if (asked.simplify == Simplify::ByPersistence && asked.persistence <= 1e300) {
    json["persistence"] = asked.persistence;
  }
  const morskin::CriticalCounts after = counts_after(report);
  json["euler_characteristic"] = euler_characteristic(after);
  json["components"] = left.complex.components;
  json["before"] = counts_json(counts_before(report), report.arcs, report.regions);
  json["after"] = counts_json(after, left.complex.arcs.size(), left.complex.regions.size());
  json["cancelled_pairs"] = left.cancelled.size();
  json["radius_share"] = report.radius_share;
  json["overlaps_before"] = left.overlaps_before;
  json["overlaps_left"] = left.overlaps_left;
  json["shrunk_radii"] = left.shrunk;
  return json;
}

void append(std::string& text, double number) { geometry::append_number(text, number); }
void append(std::string& text, CriticalId id) {
  geometry::append_number(text, std::uint64_t{id.value});
}
void append(std::string& text, const Point& p) {
  text += '[';
  append(text, p.x());
  text += ", ";
  append(text, p.y());
  text += ", ";
  append(text, p.z());
  text += ']';
}

/// An array under a name, an element to a line: element(i) appends the i-th.
template <class Element>
void append_array(std::string& text, std::string_view name, std::size_t size, Element element) {
  text += ",\n  \"";
  text += name;
  text += "\": [";
  for (std::size_t i = 0; i < size; ++i) {
    text += i == 0 ? "\n    " : ",\n    ";
    element(i);
  }
  text += size == 0 ? "]" : "\n  ]";
}

void append_point(std::string& text, const ComplexReport& report, std::size_t i) {
  constexpr std::array<std::string_view, 4> patches{"vertex", "edge", "triangle", "tetrahedron"};
  const CriticalPoint& p = report.simplified.complex.points[i];
  text += "{\"id\": ";
  append(text, CriticalId{i});
  text += ", \"index\": ";
  geometry::append_number(text, static_cast<std::uint64_t>(p.index));
  text += ", \"value\": ";
  append(text, p.value);
  text += ", \"position\": ";
  append(text, p.point.position);
  text += ", \"length_scale\": ";
  append(text, p.point.length_scale);
  text += ", \"patch\": \"";
  text += patches[static_cast<std::size_t>(report.dimension[i])];
  text += "\", \"survives\": ";
  text += report.simplified.survives[i] ? "true" : "false";
  text += ", \"radius\": ";
  append(text, report.simplified.radius[i]);
  text += "}";
}

void append_arc(std::string& text, const morse::MorseSmaleComplex& complex, std::size_t i) {
  text += "{\"saddle\": ";
  append(text, complex.arcs[i].saddle);
  text += ", \"extremum\": ";
  append(text, complex.arcs[i].extremum);
  text += ", \"points\": [";
  bool is_first = true;
  for (const Point& point : complex.line(ArcId{i})) {
    if (!is_first) text += ", ";
    is_first = false;
    append(text, point);
  }
  text += "]}";
}

template <class Pair>
void append_pair(std::string& text, const Pair& pair) {
  text += "{\"saddle\": ";
  append(text, pair.saddle);
  text += ", \"extremum\": ";
  append(text, pair.extremum);
  text += ", \"persistence\": ";
  append(text, pair.persistence);
}

}  // namespace

std::optional<ComplexFormat> complex_format_of(const std::filesystem::path& path) {
  const std::string ending = lower_extension(path);
  if (ending == ".json") return ComplexFormat::Json;
  if (ending == ".vtu") return ComplexFormat::Vtu;
  return std::nullopt;
}

morskin::CriticalCounts counts_before(const ComplexReport& report) {
  return counts(report.simplified, [](std::size_t) { return true; });
}

morskin::CriticalCounts counts_after(const ComplexReport& report) {
  return counts(report.simplified, [&](std::size_t i) { return report.simplified.survives[i]; });
}

std::string complex_json(const ComplexReport& report) {
  const morse::Simplification& left = report.simplified;
  const morse::MorseSmaleComplex& complex = left.complex;
  std::string text = head(report).dump(2, ' ', false, ordered_json::error_handler_t::replace);
  text.resize(text.rfind("\n}"));
  append_array(text, "critical_points", complex.points.size(),
               [&](std::size_t i) { append_point(text, report, i); });
  append_array(text, "arcs", complex.arcs.size(),
               [&](std::size_t i) { append_arc(text, complex, i); });
  append_array(text, "regions", complex.regions.size(), [&](std::size_t i) {
    const char* separator = "[";
    for (const CriticalId id : complex.regions[i]) {
      text += separator;
      append(text, id);
      separator = ", ";
    }
    text += "]";
  });
  append_array(text, "hierarchy", report.pairs.size(), [&](std::size_t i) {
    append_pair(text, report.pairs[i]);
    text += "}";
  });
  append_array(text, "cancelled", left.cancelled.size(), [&](std::size_t i) {
    const morse::Cancellation& c = left.cancelled[i];
    append_pair(text, c);
    text += ", \"heir\": ";
    append(text, c.heir);
    text += ", \"distance\": ";
    append(text, c.distance);
    text += "}";
  });
  return text + "\n}\n";
}

std::string complex_vtu(const ComplexReport& report) {
  const morse::Simplification& left = report.simplified;
  const morse::MorseSmaleComplex& complex = left.complex;
  std::vector<Point> points;
  geometry::VtuGrid grid;
  const auto column = [](const char* name, bool is_whole) {
    return geometry::Attribute{name, {name}, {}, is_whole};
  };
  std::array of_cells{column("index", true), column("id", true), column("arc", true),
                      column("survives", true), column("value", false)};
  // By hand: clang 14 lets no lambda capture structured bindings.
  auto &index = of_cells[0], &id = of_cells[1], &arc = of_cells[2], &survives = of_cells[3],
       &value = of_cells[4];
  const auto end_cell = [&](VtuCell kind, CriticalId named, CriticalId described,
                            double of_arc = -1) {
    arc.numbers.push_back(of_arc);
    grid.ends.push_back(static_cast<std::int64_t>(grid.corners.size()));
    grid.kinds.push_back(kind);
    index.numbers.push_back(complex.points[described.index()].index);
    value.numbers.push_back(complex.points[described.index()].value);
    id.numbers.push_back(named.value);
    survives.numbers.push_back(left.survives[named.index()]);
  };
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    points.push_back(complex.points[i].point.position);
    grid.corners.push_back(static_cast<std::int64_t>(i));
    end_cell(VtuCell::Vertex, CriticalId{i}, CriticalId{i});
  }
  for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
    const auto [saddle, extremum] = complex.arcs[i];
    const std::span<const Point> line = complex.line(ArcId{i});
    std::int64_t from = saddle.value;
    for (std::size_t k = 1; k < line.size(); ++k) {
      const bool is_end = k + 1 == line.size();
      const std::int64_t to =
          is_end ? std::int64_t{extremum.value} : static_cast<std::int64_t>(points.size());
      if (!is_end) points.push_back(line[k]);
      grid.corners.insert(grid.corners.end(), {from, to});
      end_cell(VtuCell::Line, saddle, extremum, static_cast<double>(i));
      from = to;
    }
  }
  grid.points = points;
  geometry::Attribute value_there = column("value", false);
  for (const Point& point : points) value_there.numbers.push_back(report.function(point));
  grid.point_attributes = {&value_there, 1};
  grid.cell_attributes = of_cells;
  return geometry::vtu(grid);
}

}  // namespace morskin::app
