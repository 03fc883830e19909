#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/triangulator.h"

namespace morskin::geometry {

/// What a removal works with. The vectors keep their greatest size.
struct Triangulator::Hole {
  /// A facet that is still to be joined to the other one with its corners.
  struct Open {
    std::uint64_t first_two;  // the smallest corner, then the middle one, as one number
    Corner last;              // the greatest
    Facet facet;

    bool has_corners_of(const Open& other) const {
      return first_two == other.first_two && last == other.last;
    }
  };

  Triangulator link{std::span<const WeightedPoint>()};  // of the neighbours, and the point itself
  std::vector<Corner> neighbours;
  std::vector<WeightedPoint> points;         // of the same
  std::vector<Corner> corners;               // of the whole, by corner of `link`
  std::vector<std::uint32_t> renamed;        // the new tetrahedron, by tetrahedron of `link`
  std::vector<Open> open, open_at_infinity;  // with three points, and with infinity as a corner

  /// @param facet  to be joined to the one with the corners of the facet of t at `index`
  static Open opened(const Tetrahedron& t, std::size_t index, Facet facet) {
    Corner a = t.corners[(index + 1) & 3], b = t.corners[(index + 2) & 3];
    const Corner c = t.corners[(index + 3) & 3];
    if (b < a) std::swap(a, b);
    const Corner smallest = std::min(a, c), greatest = std::max(b, c);
    const Corner middle = std::max(a, std::min(b, c));
    return {std::uint64_t{smallest} << 32 | middle, greatest, facet};
  }
};

}  // namespace morskin::geometry
