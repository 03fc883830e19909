#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/triangulator.h"

namespace morskin::geometry {

/// What a removal works with. The vectors keep their greatest size.
struct Triangulator::Hole {
  /// A facet that is still to be joined to the other one with its corners.
  struct Open {
    std::array<Corner, 3> corners;  // ascending
    Facet facet;
  };

  Triangulator link{std::span<const WeightedPoint>()};  // of the neighbours, and the point itself
  std::vector<Corner> neighbours;
  std::vector<WeightedPoint> points;   // of the same
  std::vector<Corner> corners;         // of the whole, by corner of `link`
  std::vector<std::uint32_t> renamed;  // the new tetrahedron, by tetrahedron of `link`
  std::vector<Open> open, open_at_infinity;  // with three points, and with infinity as a corner

  /// @param facet  to be joined to the one with the corners of the facet of t at `place`
  static Open opened(const Tetrahedron& t, std::size_t place, Facet facet) {
    std::array<Corner, 4> sorted = t.corners;
    std::swap(sorted[place], sorted[3]);
    std::sort(sorted.begin(), sorted.begin() + 3);
    return {{sorted[0], sorted[1], sorted[2]}, facet};
  }
};

}  // namespace morskin::geometry
