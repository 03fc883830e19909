#include "skin/power_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <utility>

namespace morskin::skin {

using geometry::AtomId;
using geometry::Point;
using geometry::Vector;
using geometry::WeightedPoint;

namespace {

constexpr std::uint32_t max_leaf = 8;

}  // namespace

PowerTree::PowerTree(std::span<const WeightedPoint> points) : ids_(points.size()) {
  std::iota(ids_.begin(), ids_.end(), 0U);
  nodes_.reserve(4 * points.size() / max_leaf + 1);
  build(points, 0, static_cast<std::uint32_t>(ids_.size()));
  points_.reserve(points.size());
  for (const std::uint32_t i : ids_) points_.push_back(points[i]);
}

std::uint32_t PowerTree::build(std::span<const WeightedPoint> points, std::uint32_t first,
                               std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  const WeightedPoint& some = points[ids_[first]];
  Node node{some.position, some.position, some.weight, first, last, 0};
  for (std::uint32_t i = first + 1; i < last; ++i) {
    const WeightedPoint& p = points[ids_[i]];
    node.low = node.low.cwiseMin(p.position);
    node.high = node.high.cwiseMax(p.position);
    node.max_weight = std::max(node.max_weight, p.weight);
  }
  nodes_.push_back(node);
  if (last - first <= max_leaf) return index;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  const auto at = [&](std::uint32_t i) { return ids_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(points[i].position[axis], i) < std::pair(points[j].position[axis], j);
  });
  build(points, first, middle);
  nodes_[index].right = build(points, middle, last);
  return index;
}

/// Boxes are looked at in doubles, whatever q is given in, and so is each atom first where that is
/// not in doubles: quadruple precision is slow.
template <class Real>
struct PowerTree::Search {
  static constexpr bool in_doubles = std::is_same_v<Real, double>;
  const Vector3<Real> q;
  std::uint32_t atom;  ///< of the least power so far
  Real least;
  double limit = rounded_up(least);
  const Point stored = q.template cast<double>();
  /// Twice what a coordinate of q loses there.
  const double loss = 0x1p-52 * stored.cwiseAbs().maxCoeff() + underflow;

  /// No atom of the box has less power: in doubles by monotonicity, otherwise because what q loses
  /// comes off each coordinate, which rounds once more, and the last subtraction is counted.
  [[gnu::always_inline]] double bound(const Point& low, const Point& high, double weight) const {
    const Vector offset = (low - stored).cwiseMax(stored - high);
    if constexpr (in_doubles) {
      return power_below<double>(offset.cwiseMax(0.0), weight);
    } else {
      const Vector less = offset - Vector::Constant(loss);
      const double power = power_below<double>(less.cwiseMax(0.0), weight);
      return power - 4 * unit_roundoff<double> * std::abs(power) - underflow;
    }
  }

  void try_atom(const WeightedPoint& p, std::uint32_t id) {
    if (!in_doubles && bound(p.position, p.position, p.weight) >= limit) return;
    const Real power = power_below<Real>(p.position.template cast<Real>() - q, p.weight);
    if (power >= least) return;
    least = power;
    limit = rounded_up(power);
    atom = id;
  }
};

template <class Real>
void PowerTree::search(Search<Real>& s, const Node& node) const {
  if (node.right == 0) {
    for (std::uint32_t i = node.first; i < node.last; ++i) s.try_atom(points_[i], ids_[i]);
    return;
  }
  const Node &left = *(&node + 1), &right = nodes_[node.right];
  const double to_left = s.bound(left.low, left.high, left.max_weight);
  const double to_right = s.bound(right.low, right.high, right.max_weight);
  const bool is_left_first = to_left <= to_right;
  if (std::min(to_left, to_right) < s.limit) search(s, is_left_first ? left : right);
  if (std::max(to_left, to_right) < s.limit) search(s, is_left_first ? right : left);
}

template <class Real>
PowerTree::Least<Real> PowerTree::least(const Vector3<Real>& q, AtomId guess,
                                        const WeightedPoint& point) const {
  const Vector3<Real> offset = point.position.cast<Real>() - q;
  Search<Real> s{q, guess.value, power_below(offset, point.weight)};
  search(s, nodes_[0]);
  return {AtomId{s.atom}, last_rounded_down(s.least)};
}

template PowerTree::Least<double> PowerTree::least(const Vector3<double>&, AtomId,
                                                   const WeightedPoint&) const;
template PowerTree::Least<Quad> PowerTree::least(const Vector3<Quad>&, AtomId,
                                                 const WeightedPoint&) const;

}  // namespace morskin::skin
