#pragma once

/// The least power distance from a point to any of many weighted points, as a proved lower bound:
/// no atom is left out, whatever is rounded.
///
/// A tree of boxes in flat arrays. Each range of the atoms is split at its median along the longest
/// side of its box, down to leaves of a few atoms. A box is passed over if even an atom at its
/// nearest point, with the largest weight in it, would have more power than one found before.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"
#include "skin/quad.h"

namespace morskin::skin {

/// The power of an atom at an offset, rounded down but for the last subtraction. The computed
/// square is at most (1 + u)^5 < 1 + 8 u times the true one: a difference of coordinates is rounded
/// once and squared, the square and two sums once each.
///
/// Rounding is monotone: with no component of the offset larger in magnitude and no smaller weight
/// the result is not larger. So a box bounds its atoms without any margin.
template <class Real>
Real power_below(const Vector3<Real>& offset, double weight) {
  constexpr Real down = 1 - 8 * unit_roundoff<Real>;
  const Real square = offset.x() * offset.x() + offset.y() * offset.y() + offset.z() * offset.z();
  return square * down - Real(weight);
}

/// The same with the last subtraction rounded down too; squares may have been rounded to subnormal
/// numbers.
template <class Real>
Real last_rounded_down(const Real& power) {
  return power - 4 * unit_roundoff<Real> * magnitude(power) - underflow;
}

class PowerTree {
 public:
  /// @pre there is a point; all are finite.
  explicit PowerTree(std::span<const geometry::WeightedPoint> points);

  template <class Real>
  struct Least {
    geometry::AtomId atom;  ///< with the least power, to rounding
    Real lower_bound;       ///< on |q - z|^2 - w over all atoms, Angstrom^2
  };
  /// @tparam Real  double or Quad: what q is given in and all is computed in
  /// @param guess  an atom, and its point; the nearer to the one sought, the shorter the search
  template <class Real>
  Least<Real> least(const Vector3<Real>& q, geometry::AtomId guess,
                    const geometry::WeightedPoint& point) const;

 private:
  struct Node {
    geometry::Point low, high;
    double max_weight;
    std::uint32_t first, last;  ///< atoms, in the order of the tree
    std::uint32_t right;        ///< the second child; the first follows its parent. 0 for a leaf
  };
  template <class Real>
  struct Search;
  std::uint32_t build(std::span<const geometry::WeightedPoint> points, std::uint32_t first,
                      std::uint32_t last);
  template <class Real>
  void search(Search<Real>& s, const Node& node) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> ids_;               ///< in the order of the tree
  std::vector<geometry::WeightedPoint> points_;  ///< in the order of the tree
};

}  // namespace morskin::skin
