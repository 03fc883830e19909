#pragma once

/// The Morse-Smale complex of a Morse function on the skin (section 3.2): critical points, the
/// integral lines that join them, and the regions between.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "morse/critical_points.h"

namespace morskin::morse {

using ArcId = geometry::Id<struct ArcTag>;

/// An integral line from a saddle to a minimum or a maximum.
struct Arc {
  CriticalId saddle, extremum;
};

struct MorseSmaleComplex {
  std::vector<CriticalPoint> points;
  /// Four to a saddle, together, counter-clockwise about it seen from outside: descending along
  /// its `descending` direction, ascending, descending the other way, ascending the other way.
  std::vector<Arc> arcs;
  /// Regions, each minimum, saddle, maximum, saddle, counter-clockwise seen from outside; twice as
  /// many as there are saddles.
  std::vector<std::array<CriticalId, 4>> regions;
  /// Connected components of the skin.
  std::size_t components = 0;

  /// The arc's polyline from the saddle to the extremum, both included.
  std::span<const Point> line(ArcId arc) const {
    return {line_points.data() + first_point[arc.index()],
            first_point[arc.index() + 1] - first_point[arc.index()]};
  }
  std::vector<Point> line_points;
  std::vector<std::uint32_t> first_point;  ///< by arc, into line_points
};

}  // namespace morskin::morse
