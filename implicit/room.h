#pragma once

/// The part of space in which a surface's second derivatives have to be bounded: about each of its
/// points as far as the laws of the seam speak of it, and no farther.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kd_tree.h"
#include "implicit/cover.h"

namespace morskin::implicit {

/// Balls about the boxes of a cover. Each goes beyond its box by `reach` times a bound on the
/// length scale there.
///
/// Law: it holds the ball of radius reach * rho(x) about each point x of the surface, for
/// rho(x) <= |grad f(x)| / M.
class Room {
 public:
  /// The free balls at x lie within 2 rho(x); the rest is for points that lie off the surface.
  static constexpr double reach = 3;

  /// @param M  above 0
  Room(const Cover& cover, double M);

  /// Whether one of the balls contains the ball about x: a yes is certain.
  bool contains(const Point& x, double radius) const;
  /// Whether the ball about x may meet a box of the cover: a no is certain.
  bool may_meet_cover(const Point& x, double radius) const;

  using Ids = std::vector<std::uint32_t>;
  /// All balls, and a cube that holds them.
  Ids all() const;
  Box cube() const;
  /// Those of some balls that a box may meet; one alone where that contains the box.
  Ids meeting(const Box& box, std::span<const std::uint32_t> balls) const;

 private:
  using Tree = geometry::KdTree<geometry::Id<Room>>;

  std::vector<Point> centres_;
  std::vector<double> box_radii_, radii_;
  double max_box_radius_ = 0, max_radius_ = 0;
  Tree tree_;
};

}  // namespace morskin::implicit
