#pragma once

/// The Gaussian surface of balls: where the sum of
///
///     exp(-decay (|x - a|^2 - r^2))
///
/// over all balls is `level`. As a function its logarithm,
///
///     f(x) = -log(sum / level) / decay    (Angstrom^2),
///
/// a softened least power distance: with p the shares of the balls in the sum and m = sum p a their
/// mean, grad f = 2 (x - m), and half the Hessian is 1 - 2 decay (covariance of the a under p).

#include <cstdint>
#include <span>
#include <vector>

#include "implicit/function.h"

namespace morskin::implicit {

struct Ball {
  Point centre;
  double radius;  ///< Angstrom
};

struct GaussianOptions {
  double decay = 0.5;  ///< per Angstrom^2: the larger, the closer to the union of the balls
  double level = 1;
};

class Gaussians final : public Function {
 public:
  /// @throws geometry::RefusedInput  without balls, or for numbers out of range
  Gaussians(std::vector<Ball> balls, const GaussianOptions& options);

  Value at(const Point& x) const override;
  Jet<Interval, 1> enclose(const Point& x) const override;
  Jet<Interval, 2> over(const Box& box) const override;

  /// A box outside which f is above zero.
  const Box& extent() const { return extent_; }
  /// The sum, where f has some value.
  double sum_at(double f) const;

 private:
  using Ids = std::span<const std::uint32_t>;

  /// The balls that count in each voxel of the extent.
  struct Grid {
    double tail = 0;                 ///< the others have less than this share of the sum, together
    std::vector<std::size_t> first;  ///< by voxel, into ids
    std::vector<std::uint32_t> ids;
  };
  void fill_grids();
  /// Those of some balls that count in a ball of space, all but a tail.
  std::vector<std::uint32_t> counting(Ids ids, const Point& middle, double radius,
                                      double tail) const;
  /// The balls that count all over a box.
  Ids near(const Box& box, const Grid& grid) const;
  /// The voxel of a point; voxel_count() outside of the grid.
  std::size_t voxel(const Point& x) const;
  std::size_t voxel_count() const { return fine_.first.size() - 1; }
  double least_power(const Point& x, Ids ids) const;

  /// The terms at a point, as intervals.
  struct Terms;
  Terms terms(const Point& x, Ids ids, double tail) const;
  /// The shares of balls in the sum, all over a box.
  /// @param half  of the box
  /// @param off   the balls' centres, less the reference
  std::vector<Interval> shares(double half, const Terms& at_centre,
                               std::span<const Triple<Interval>> off) const;

  std::vector<Ball> balls_;
  GaussianOptions options_;
  Box extent_;
  std::vector<std::uint32_t> all_;
  double farthest_ = 0;  ///< bound on the distance of two centres, and of one from the extent
  int voxels_ = 0;       ///< along each side of the extent
  double voxel_side_ = 0;
  Grid fine_, coarse_;  ///< for points, and for boxes, over which bounds are wider anyway
};

}  // namespace morskin::implicit
