#pragma once

/// The cyclic order of the integral lines that end at one extremum.
///
/// Lines of one kind run together exponentially fast, soon closer than rounding, but they never
/// cross. So where the angles at the end cannot tell two lines apart, their order is read where
/// they are still apart, on a level farther up the lines.

#include <vector>

#include "morse/integral_lines.h"

namespace morskin::morse {

/// From `level` on to the extremum, `child` follows `parent`.
struct Merge {
  std::uint32_t child, parent;
  double level;
};

/// A line with where it came in.
struct ArrivingLine {
  std::uint32_t id;
  LineNodes nodes;
  Arrival arrival;
};

struct LineOrder {
  std::vector<std::uint32_t> ids;  ///< counter-clockwise about the extremum, seen from outside
  std::vector<Merge> merges;       ///< each child once; parents have smaller ids
  bool is_certain = true;          ///< whether rounding could not have decided any pair
};

/// @param arriving  the lines that end at one extremum, by rising id
LineOrder order_of(const IntegralLines& lines, std::vector<ArrivingLine> arriving);

}  // namespace morskin::morse
