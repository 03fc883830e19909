#include "geometry/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/predicates.h"
#include "geometry/spatial_order.h"
#include "geometry/triangle_contact.h"

namespace morskin::geometry {

namespace {

/// An axis-parallel box in single precision, rounded outwards.
struct FloatBox {
  std::array<float, 3> low, high;

  static constexpr float infinite = std::numeric_limits<float>::infinity();
  static FloatBox empty() {
    return {{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}};
  }
  void add(const Point& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = p[static_cast<Eigen::Index>(k)];
      const auto near = static_cast<float>(x);
      const float below = static_cast<double>(near) > x ? std::nextafter(near, -infinite) : near;
      const float above = static_cast<double>(near) < x ? std::nextafter(near, infinite) : near;
      low[k] = std::min(low[k], below);
      high[k] = std::max(high[k], above);
    }
  }
  void add(const FloatBox& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  bool meets(const FloatBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
  }
};

/// The triangles that are not degenerate, along a Hilbert curve through their centroids.
std::vector<std::uint32_t> ordered_triangles(const IndexedMesh& mesh, const ExactPositions& at) {
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Point& p : at.all()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  constexpr int bits = 20;
  const double extent = std::max((high - low).maxCoeff(), std::numeric_limits<double>::min());
  const auto cell = [&](double x, double from) {
    return static_cast<std::uint32_t>(
        std::clamp((x - from) / extent * ((1 << bits) - 1), 0.0, double((1 << bits) - 1)));
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (a == b || b == c || c == a || are_collinear(at[a], at[b], at[c])) continue;
    const Point centroid = (at[a] + at[b] + at[c]) / 3;
    order.emplace_back(hilbert_index(cell(centroid.x(), low.x()), cell(centroid.y(), low.y()),
                                     cell(centroid.z(), low.z()), bits),
                       t);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> result(order.size());
  std::transform(order.begin(), order.end(), result.begin(),
                 [](const auto& o) { return o.second; });
  return result;
}

/// A binary tree of boxes over triangles in spatial order, with a few consecutive ones in each
/// leaf. Node i of a level covers nodes 2 i and 2 i + 1 of the one below.
class BoxTree {
 public:
  static constexpr std::size_t leaf_size = 4;

  BoxTree(const IndexedMesh& mesh, const ExactPositions& at)
      : triangles_(ordered_triangles(mesh, at)), boxes_(triangles_.size(), FloatBox::empty()) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      for (const std::uint32_t v : mesh.triangles[triangles_[i]]) boxes_[i].add(at[v]);
    }
    std::span<const FloatBox> below = boxes_;
    std::size_t arity = leaf_size;
    while (below.size() > 1 || levels_.empty()) {
      std::vector<FloatBox> level((below.size() + arity - 1) / arity, FloatBox::empty());
      for (std::size_t i = 0; i < below.size(); ++i) level[i / arity].add(below[i]);
      levels_.push_back(std::move(level));
      below = levels_.back();
      arity = 2;
    }
  }

  /// Calls visit(s, t) for each two triangles whose boxes meet, until it returns false.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    if (triangles_.empty()) return;
    std::vector<Pair> open{{levels_.size() - 1, 0, 0}};
    while (!open.empty()) {
      const Pair p = open.back();
      open.pop_back();
      if (p.level == 0) {
        if (!visit_leaves(p.i, p.j, visit)) return;
        continue;
      }
      const std::vector<FloatBox>& below = levels_[p.level - 1];
      const std::size_t i_end = std::min(2 * p.i + 2, below.size());
      const std::size_t j_end = std::min(2 * p.j + 2, below.size());
      for (std::size_t i = 2 * p.i; i < i_end; ++i) {
        for (std::size_t j = p.i == p.j ? i : 2 * p.j; j < j_end; ++j) {
          if (i == j || below[i].meets(below[j])) open.push_back({p.level - 1, i, j});
        }
      }
    }
  }

 private:
  struct Pair {
    std::size_t level, i, j;
  };

  template <class Visit>
  bool visit_leaves(std::size_t first, std::size_t second, Visit visit) const {
    const std::size_t i_end = std::min((first + 1) * leaf_size, triangles_.size());
    const std::size_t j_end = std::min((second + 1) * leaf_size, triangles_.size());
    for (std::size_t i = first * leaf_size; i < i_end; ++i) {
      for (std::size_t j = first == second ? i + 1 : second * leaf_size; j < j_end; ++j) {
        if (boxes_[i].meets(boxes_[j]) && !visit(triangles_[i], triangles_[j])) return false;
      }
    }
    return true;
  }

  std::vector<std::uint32_t> triangles_;
  std::vector<FloatBox> boxes_;  ///< by index in triangles_
  std::vector<std::vector<FloatBox>> levels_;
};

}  // namespace

SelfIntersections self_intersections(const IndexedMesh& mesh,
                                     const SelfIntersectionLimits& limits) {
  SelfIntersections result;
  const ExactPositions positions(mesh.positions);
  // Lists the smallest pairs found: a heap with the largest on top.
  std::vector<std::pair<std::uint32_t, std::uint32_t>>& smallest = result.pairs;
  const BoxTree tree(mesh, positions);
  tree.for_each_pair([&](std::uint32_t s, std::uint32_t t) {
    if (!is_improper_contact(positions, mesh.triangles[s], mesh.triangles[t])) return true;
    if (result.count == limits.counted) return result.is_complete = false;
    ++result.count;
    smallest.emplace_back(std::min(s, t), std::max(s, t));
    std::push_heap(smallest.begin(), smallest.end());
    if (smallest.size() > limits.listed) {
      std::pop_heap(smallest.begin(), smallest.end());
      smallest.pop_back();
    }
    return true;
  });
  std::sort_heap(smallest.begin(), smallest.end());
  return result;
}

}  // namespace morskin::geometry
