#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/box.h"

namespace morskin::geometry {

/// Space halved again and again: a complete binary tree of boxes. The halves of box k are the boxes
/// 2 k + 1 and 2 k + 2, the root is all of space.
class Dissection {
 public:
  /// Halves at the median of the samples in a box, across the longest side of their bounding box.
  /// @param depth  how often
  Dissection(std::vector<Point> samples, int depth);

  std::size_t size() const { return boxes_.size(); }
  const Box& operator[](std::size_t k) const { return boxes_[k]; }
  bool is_leaf(std::size_t k) const { return k >= first_leaf(); }
  std::size_t first_leaf() const { return boxes_.size() / 2; }
  std::size_t leaf_count() const { return boxes_.size() - first_leaf(); }

  /// The box that contains x of those from `first` to 2 first: of one level.
  std::size_t box_of(const Point& x, std::size_t first) const {
    std::size_t k = 0;
    while (k < first) k = boxes_[lower_half(k)].contains(x, 0) ? lower_half(k) : upper_half(k);
    return k;
  }
  /// Calls visit(k) for each box of that level that has a point within a distance of x.
  template <class Visit>
  void for_each_that_meets(const Point& x, double distance, std::size_t first, Visit visit,
                           std::size_t k = 0) const {
    if (!boxes_[k].meets(x, distance)) return;
    if (k >= first) return visit(k);
    for_each_that_meets(x, distance, first, visit, lower_half(k));
    for_each_that_meets(x, distance, first, visit, upper_half(k));
  }

  static std::size_t lower_half(std::size_t k) { return 2 * k + 1; }
  static std::size_t upper_half(std::size_t k) { return 2 * k + 2; }
  static bool is_lower_half(std::size_t k) { return k % 2 == 1; }
  /// @pre k > 0
  static std::size_t parent(std::size_t k) { return (k - 1) / 2; }

 private:
  void halve(std::size_t k, std::span<Point> samples);

  std::vector<Box> boxes_;
};

}  // namespace morskin::geometry
