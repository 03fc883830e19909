#include "geometry/point_tree.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace morskin::geometry {

PointTree::PointTree(std::span<const Point> points) : ids_(points.size()) {
  std::iota(ids_.begin(), ids_.end(), 0U);
  if (points.empty()) return;
  // Halving leaves the counts of a level at most one apart, so it ends at the same depth all over,
  // give or take a level.
  const std::size_t leaves = std::bit_ceil((points.size() + leaf_size - 1) / leaf_size);
  nodes_.resize(2 * leaves);
  build(points, 0, 0, ids_.size());
  points_.reserve(points.size());
  for (const std::uint32_t i : ids_) points_.push_back(points[i]);
}

void PointTree::build(std::span<const Point> points, std::size_t node, std::size_t begin,
                      std::size_t end) {
  if (end - begin <= leaf_size) return;
  Point low = points[ids_[begin]], high = low;
  for (std::size_t i = begin + 1; i < end; ++i) {
    low = low.cwiseMin(points[ids_[i]]);
    high = high.cwiseMax(points[ids_[i]]);
  }
  Node& cut = nodes_[node];
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  cut.axis = static_cast<int>(axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) { return ids_.begin() + static_cast<std::ptrdiff_t>(i); };
  // Ties fall by id, so that the tree is the same with every standard library.
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t i, std::uint32_t j) {
    const double x = points[i][axis], y = points[j][axis];
    return x != y ? x < y : i < j;
  });
  cut.high_begin = points[ids_[middle]][axis];
  cut.low_end = points[ids_[begin]][axis];
  for (std::size_t i = begin; i < middle; ++i) {
    cut.low_end = std::max(cut.low_end, points[ids_[i]][axis]);
  }
  build(points, 2 * node + 1, begin, middle);
  build(points, 2 * node + 2, middle, end);
}

}  // namespace morskin::geometry
