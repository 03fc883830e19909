#pragma once

/// Sizes that grow slowly from where they are small: at x the least of
///
///     size(p) + slope |x - p|     over sources p,
///
/// the largest function of that slope below the sizes of all sources. A tree of boxes in flat
/// arrays finds it: a box is passed over if even its smallest size at its nearest point is more
/// than one found before.
/// Source: Persson, "Mesh size functions for implicit geometries and PDE-based gradient limiting"
///         (Engineering with Computers 2006), where it is the limited size of points.

#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace morskin::surface {

using geometry::Point;

class SizeField {
 public:
  struct Source {
    Point position;
    double size;  ///< Angstrom, >= 0
  };

  /// Keeps only sources that count: of one that another makes larger than allowed nothing is left.
  /// @param slope  Angstrom for an Angstrom, > 0
  SizeField(std::vector<Source> sources, double slope);

  /// The least of a size at x and of what the sources allow there.
  double limited(double size, const Point& x) const;
  double slope() const { return slope_; }
  std::size_t source_count() const { return sources_.size(); }

 private:
  struct Node {
    Point low, high;
    double min_size;
    std::uint32_t first, last;  ///< sources
    std::uint32_t right;        ///< the second child; the first follows its parent. 0 for a leaf
  };
  void build();
  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  double bound(const Node& node, const Point& x) const;
  void search(const Node& node, const Point& x, double& least) const;

  double slope_;
  std::vector<Source> sources_;  ///< in the order of the tree
  std::vector<Node> nodes_;
};

}  // namespace morskin::surface
