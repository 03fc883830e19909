#pragma once

/// A tree of boxes over triangles, for the pairs whose boxes meet.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geometry/id.h"
#include "geometry/indexed_mesh.h"
#include "geometry/point.h"

namespace morskin::geometry {

/// An axis-parallel box in single precision, rounded outwards.
struct FloatBox {
  static constexpr float infinite = std::numeric_limits<float>::infinity();

  std::array<float, 3> low{infinite, infinite, infinite}, high{-infinite, -infinite, -infinite};

  /// Adds all points within `margin` of p along the axes.
  void add(const Point& p, double margin) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = p[static_cast<Eigen::Index>(k)];
      low[k] = std::min(low[k], std::nextafter(static_cast<float>(x - margin), -infinite));
      high[k] = std::max(high[k], std::nextafter(static_cast<float>(x + margin), infinite));
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

/// A binary tree with a few consecutive triangles in each leaf node. Node i of a level covers nodes
/// 2 i and 2 i + 1 of the one below. Each knows the corners that all its triangles share.
class BoxTree {
 public:
  struct Leaf {
    std::uint32_t triangle;
    FloatBox box;
  };

  /// @param leaves  neighbours should be near each other
  /// @param corners  by triangle; must outlive this object
  BoxTree(std::vector<Leaf> leaves, std::span<const TriangleCorners> corners)
      : leaves_(std::move(leaves)), corners_(corners) {
    std::vector<Node> level((leaves_.size() + leaf_size - 1) / leaf_size);
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      add(level[i / leaf_size], {leaves_[i].box, corners_[leaves_[i].triangle]},
          i % leaf_size == 0);
    }
    levels_.push_back(std::move(level));
    while (levels_.back().size() > 1) {
      const std::vector<Node>& below = levels_.back();
      std::vector<Node> above((below.size() + 1) / 2);
      for (std::size_t i = 0; i < below.size(); ++i) add(above[i / 2], below[i], i % 2 == 0);
      levels_.push_back(std::move(above));
    }
  }

  /// Calls visit(s, t) for each two triangles whose boxes meet and that share no corner that is
  /// exempt, until it returns false.
  /// @return whether it never did
  template <class IsExempt, class Visit>
  bool for_each_pair(IsExempt is_exempt, Visit visit) const {
    if (leaves_.empty()) return true;
    std::vector<Pair> open{{levels_.size() - 1, 0, 0}};
    while (!open.empty()) {
      const Pair p = open.back();
      open.pop_back();
      const Node &a = levels_[p.level][p.i], &b = levels_[p.level][p.j];
      if (!a.box.meets(b.box) || share(a.common, b.common, is_exempt)) continue;
      if (p.level == 0) {
        if (!visit_leaves(p.i, p.j, is_exempt, visit)) return false;
        continue;
      }
      const std::size_t count = levels_[p.level - 1].size();
      for (std::size_t i = 2 * p.i; i < std::min(2 * p.i + 2, count); ++i) {
        for (std::size_t j = p.i == p.j ? i : 2 * p.j; j < std::min(2 * p.j + 2, count); ++j) {
          open.push_back({p.level - 1, i, j});
        }
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t leaf_size = 4;

  struct Node {
    FloatBox box;
    TriangleCorners common{no_index, no_index, no_index};  ///< then no_index
  };
  struct Pair {
    std::size_t level, i, j;
  };

  static bool has(const TriangleCorners& corners, std::uint32_t v) {
    return corners[0] == v || corners[1] == v || corners[2] == v;
  }

  static void add(Node& node, const Node& part, bool is_first) {
    node.box.add(part.box);
    if (is_first) {
      node.common = part.common;
      return;
    }
    TriangleCorners common{no_index, no_index, no_index};
    std::size_t count = 0;
    for (const std::uint32_t v : node.common) {
      if (v != no_index && has(part.common, v)) common[count++] = v;
    }
    node.common = common;
  }

  template <class IsExempt>
  static bool share(const TriangleCorners& a, const TriangleCorners& b, const IsExempt& is_exempt) {
    return std::ranges::any_of(
        a, [&](std::uint32_t v) { return v != no_index && has(b, v) && is_exempt(v); });
  }

  template <class IsExempt, class Visit>
  bool visit_leaves(std::size_t first, std::size_t second, const IsExempt& is_exempt,
                    Visit& visit) const {
    const std::size_t i_end = std::min((first + 1) * leaf_size, leaves_.size());
    const std::size_t j_end = std::min((second + 1) * leaf_size, leaves_.size());
    for (std::size_t i = first * leaf_size; i < i_end; ++i) {
      for (std::size_t j = first == second ? i + 1 : second * leaf_size; j < j_end; ++j) {
        const std::uint32_t s = leaves_[i].triangle, t = leaves_[j].triangle;
        if (!leaves_[i].box.meets(leaves_[j].box)) continue;
        if (!share(corners_[s], corners_[t], is_exempt) && !visit(s, t)) return false;
      }
    }
    return true;
  }

  std::vector<Leaf> leaves_;
  std::span<const TriangleCorners> corners_;
  std::vector<std::vector<Node>> levels_;
};

}  // namespace morskin::geometry
