#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// A fixed set of points, to be asked which of them lie in a ball: a balanced tree that halves the
/// points across the longest side of their box, in one flat array, down to leaves of a few.
class PointTree {
 public:
  /// @param points  all finite; copied.
  explicit PointTree(std::span<const Point> points);

  /// Calls visit(i) for each point nearer than the radius to the centre, in no particular order but
  /// always the same.
  template <class Visit>
  void for_each_in_ball(const Point& centre, double squared_radius, Visit visit) const {
    if (!nodes_.empty()) search(0, 0, ids_.size(), centre, squared_radius, visit);
  }

 private:
  static constexpr std::size_t leaf_size = 8;

  /// The points below a node are cut in the middle of their array: the first half has coordinates
  /// of at most `low_end` along the axis, the second of at least `high_begin`. The children of node
  /// n are 2 n + 1 and 2 n + 2.
  struct Node {
    double low_end = 0, high_begin = 0;
    int axis = 0;
  };

  void build(std::span<const Point> points, std::size_t node, std::size_t begin, std::size_t end);

  template <class Visit>
  void search(std::size_t node, std::size_t begin, std::size_t end, const Point& centre,
              double squared_radius, Visit& visit) const {
    if (end - begin <= leaf_size) {
      for (std::size_t i = begin; i < end; ++i) {
        if ((points_[i] - centre).squaredNorm() < squared_radius) visit(ids_[i]);
      }
      return;
    }
    const Node& cut = nodes_[node];
    const std::size_t middle = begin + (end - begin) / 2;
    const double x = centre[cut.axis];
    const auto reaches = [squared_radius](double gap) {
      return gap <= 0 || gap * gap < squared_radius;
    };
    if (reaches(x - cut.low_end)) {
      search(2 * node + 1, begin, middle, centre, squared_radius, visit);
    }
    if (reaches(cut.high_begin - x)) {
      search(2 * node + 2, middle, end, centre, squared_radius, visit);
    }
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> ids_;  ///< in the order of the leaves
  std::vector<Point> points_;       ///< in that order
};

}  // namespace morskin::geometry
