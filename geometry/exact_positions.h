#pragma once

#include <span>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// The positions of a mesh from any file, in the range in which signs of degree three
/// (`orientation`, `are_collinear`) are exact: at most 2^30 in magnitude and multiples of 2^-300,
/// so that a product of three differences neither overflows nor loses its last bit.
///
/// Positions out of range are scaled by one power of two, which changes no sign, and rounded to
/// multiples of 2^-300, which changes only coordinates below 2^-248, more than 2^277 times smaller
/// than the largest.
class ExactPositions {
 public:
  /// @param positions  all finite; must outlive this object.
  explicit ExactPositions(std::span<const Point> positions);

  const Point& operator[](std::size_t i) const { return positions_[i]; }
  std::span<const Point> all() const { return positions_; }

 private:
  std::vector<Point> scaled_;  ///< empty when the positions are in range
  std::span<const Point> positions_;
};

}  // namespace morskin::geometry
