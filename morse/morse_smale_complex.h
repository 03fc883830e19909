#pragma once

/// The Morse-Smale complex of a Morse function on the skin (section 3.2): critical points, the
/// integral lines that join them, and the regions between.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/grouped.h"
#include "geometry/run.h"
#include "morse/critical_points.h"

namespace morskin::morse {

using ArcId = geometry::Id<struct ArcTag>;

/// An integral line from a saddle to a minimum or a maximum.
struct Arc {
  CriticalId saddle, extremum;
};

struct MorseSmaleComplex {
  std::vector<CriticalPoint> points;
  /// Four consecutive ones for each saddle, counter-clockwise about it seen from outside:
  /// descending along its `descending` direction, ascending, and the two opposite ones.
  std::vector<Arc> arcs;
  /// Two for each saddle, each minimum, saddle, maximum, saddle, counter-clockwise seen from
  /// outside.
  std::vector<std::array<CriticalId, 4>> regions;
  /// Connected components of the skin.
  std::size_t components = 0;
  /// By point, the arcs that end at an extremum, counter-clockwise about it seen from outside.
  std::span<const ArcId> arcs_at(CriticalId extremum) const { return ends.of(extremum.index()); }
  geometry::Grouped<ArcId> ends;
  /// Lines that come within the merge distance of one of their kind and follow it from there.
  std::size_t merged_lines = 0;
  /// Why this may not be the complex, or nothing: degeneracies of the critical points, and lines
  /// indistinguishable from one between two saddles. If they leave the complex undecided, `regions`
  /// is empty; if a line has no end, `arcs` and `components` are too. Regions are always
  /// quadrangles.
  std::vector<std::string> degeneracies;

  /// The arc's polyline from the saddle to the extremum, both included.
  std::span<const Point> line(ArcId arc) const {
    return {line_points.data() + first_point[arc.index()],
            first_point[arc.index() + 1] - first_point[arc.index()]};
  }
  std::vector<Point> line_points;
  std::vector<std::uint32_t> first_point;  ///< by arc, into line_points
};

/// Whether a complex keeps the polylines of its arcs, by far the most of it.
enum class Polylines { Keep, Drop };

/// Traces the lines, then the regions from the cyclic order of the arcs at all points; that each
/// region has four sides confirms the order.
/// @param run  receives the share of lines traced
/// @pre  critical = critical_points(skin, f).
/// Source: Edelsbrunner, Harer and Zomorodian, hierarchical Morse-Smale complexes (2003).
MorseSmaleComplex morse_smale_complex(const skin::SkinSurface& skin, const MorseFunction& f,
                                      const CriticalPoints& critical,
                                      Polylines polylines = Polylines::Keep,
                                      const geometry::Run& run = geometry::Run());

}  // namespace morskin::morse
