#pragma once

/// The Morse-Smale complex in files: JSON for programs, VTU for ParaView.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "morse/simplification.h"
#include "morskin/method.h"

namespace morskin::app {

enum class ComplexFormat { Json, Vtu };

/// The format that a file's ending stands for, in upper or lower case.
std::optional<ComplexFormat> complex_format_of(const std::filesystem::path& path);

/// The report of `morskin morse`.
struct ComplexReport {
  MorseArguments arguments;
  morse::MorseFunction function;  ///< the one used
  std::vector<int> dimension;     ///< by critical point, of the simplex whose patch it lies on
  /// Of the complex as traced.
  std::size_t arcs = 0, regions = 0;
  std::vector<morse::PersistencePair> pairs;
  double radius_share = 0;  ///< radius of a protecting sphere over the length scale
  morse::Simplification simplified;
};

/// Of all points, or of those that survive.
morskin::CriticalCounts counts_before(const ComplexReport& report);
morskin::CriticalCounts counts_after(const ComplexReport& report);

/// One JSON object, one critical point, arc, region or pair to a line, every number to the last
/// bit. Ids are indices in `critical_points`, which lists all of them.
std::string complex_json(const ComplexReport& report);

/// Critical points as vertices, in order of their ids, then the arcs as lines from node to node.
/// Numbers on points: `value`, of the function. On cells: `index`, `value` (of the critical point,
/// or of the extremum at the arc's end), `id` (of the critical point or the saddle), `arc` (its
/// index among the arcs; -1 for a critical point) and `survives`, 0 or 1.
std::string complex_vtu(const ComplexReport& report);

}  // namespace morskin::app
