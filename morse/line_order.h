#pragma once

/// The cyclic order of the integral lines that end at one extremum.
///
/// Lines of one kind converge exponentially, soon to within rounding, but never cross. Where the
/// angles at the end do not separate two lines, their order is read on a level farther up, where
/// they are still apart.

#include <vector>

#include "morse/integral_lines.h"

namespace morskin::morse {

/// From `level` on to the extremum, `child` follows `parent`.
struct Merge {
  std::uint32_t child, parent;
  double level;
};

/// A line and its arrival.
struct ArrivingLine {
  std::uint32_t id;
  LineNodes nodes;
  Arrival arrival;
};

struct LineOrder {
  std::vector<std::uint32_t> ids;  ///< counter-clockwise about the extremum, seen from outside
  std::vector<Merge> merges;       ///< each child once; parents have smaller ids
  bool is_certain = true;          ///< whether all pairs are beyond rounding
};

/// @param arriving  the lines that end at one extremum, by rising id
LineOrder order_of(const IntegralLines& lines, std::vector<ArrivingLine> arriving);

}  // namespace morskin::morse
