#pragma once

/// A static kd-tree in flat arrays: the nearest point within a radius, and all points within a
/// radius.
///
/// The tree has no pointers. Each range of the array is split at its median along the longest side
/// of its box; the median is the node, the two halves are the subtrees. Ranges of a few points are
/// leaves.
///
/// The nearest point is that of a linear search in the order of ids, ties included; all points
/// within a radius are those of one too, in another order.
/// Source: Friedman, Bentley & Finkel 1977.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::geometry {

/// @tparam Id  of a point: its index in the span that the tree was built from
template <class Id>
class KdTree {
 public:
  struct Neighbour {
    Id id;
    double squared_distance;  ///< Angstrom^2
  };

  /// @pre all points are finite; fewer than 2^32.
  explicit KdTree(std::span<const Point> points) : ids_(points.size()), axis_(points.size()) {
    std::iota(ids_.begin(), ids_.end(), 0U);
    build(points, 0, ids_.size());
    points_.reserve(points.size());
    for (const std::uint32_t i : ids_) points_.push_back(points[i]);
  }

  std::size_t size() const { return ids_.size(); }

  /// The nearest point no farther than `radius`; of several the one with the lowest id.
  ///
  /// @param accept  accept(Id) -> bool, whether a point counts
  template <class Accept>
  std::optional<Neighbour> nearest(const Point& x, double radius, const Accept& accept) const {
    std::optional<Neighbour> best;
    double limit = radius * radius;
    search(x, 0, size(), limit, [&](std::uint32_t id, double squared_distance) {
      if (!accept(Id{id})) return;
      if (best && squared_distance == limit && best->id < Id{id}) return;
      best = Neighbour{Id{id}, squared_distance};
      limit = squared_distance;
    });
    return best;
  }
  std::optional<Neighbour> nearest(const Point& x, double radius) const {
    return nearest(x, radius, [](Id) { return true; });
  }

  /// Visits all points no farther than `radius`, in a fixed order.
  /// @param visit  visit(Neighbour)
  template <class Visit>
  void for_each_within(const Point& x, double radius, const Visit& visit) const {
    double limit = radius * radius;
    search(x, 0, size(), limit, [&](std::uint32_t id, double squared_distance) {
      visit(Neighbour{Id{id}, squared_distance});
    });
  }

 private:
  /// Largest leaf: about where another level of the tree stops paying.
  static constexpr std::size_t leaf = 8;

  void build(std::span<const Point> points, std::size_t first, std::size_t last) {
    if (last - first <= leaf) return;
    Point low = points[ids_[first]], high = low;
    for (std::size_t i = first + 1; i < last; ++i) {
      low = low.cwiseMin(points[ids_[i]]);
      high = high.cwiseMax(points[ids_[i]]);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return ids_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t i, std::uint32_t j) {
      return std::pair(points[i][axis], i) < std::pair(points[j][axis], j);
    });
    axis_[middle] = static_cast<std::uint8_t>(axis);
    build(points, first, middle);
    build(points, middle + 1, last);
  }

  /// Visits points within the squared distance `limit`, which the visitor may lower. Depth: log2 of
  /// the size.
  template <class Visit>
  void search(const Point& x, std::size_t first, std::size_t last, double& limit,
              const Visit& visit) const {
    const auto test = [&](std::size_t i) {
      const double squared_distance = (points_[i] - x).squaredNorm();
      if (squared_distance <= limit) visit(ids_[i], squared_distance);
    };
    if (last - first <= leaf) {
      for (std::size_t i = first; i < last; ++i) test(i);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    const double beyond = x[axis_[middle]] - points_[middle][axis_[middle]];
    test(middle);
    const bool right_first = beyond > 0;
    right_first ? search(x, middle + 1, last, limit, visit)
                : search(x, first, middle, limit, visit);
    // Rounding is monotone, so no point beyond the plane has a computed distance below this.
    if (beyond * beyond > limit) return;
    right_first ? search(x, first, middle, limit, visit)
                : search(x, middle + 1, last, limit, visit);
  }

  std::vector<std::uint32_t> ids_;  ///< in the order of the tree
  std::vector<std::uint8_t> axis_;  ///< of the plane through a node, by slot
  std::vector<Point> points_;       ///< by slot
};

}  // namespace morskin::geometry
