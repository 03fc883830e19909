#pragma once

/// All critical points of a height on a zero set: found by exclusion and Krawczyk's test, so that
/// none is missed and none counted twice.
///
/// With two directions u and v the height is that along u x v, and its critical points are the
/// zeros of F = (f, u . grad f, v . grad f). Boxes without a zero are excluded, in others the test
/// proves one zero, or they are halved.

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "geometry/run.h"
#include "implicit/cover.h"

namespace morskin::implicit {

/// Two directions, nearly orthogonal unit vectors.
struct LevelDirections {
  Vector u, v;

  /// @param height  not zero
  static LevelDirections of(const Vector& height);
  Vector height() const { return u.cross(v); }
};

struct CriticalHeight {
  Point position;
  double doubt;  ///< the zero is no farther from `position`, Angstrom
  int index;     ///< 0 minimum, 1 saddle, 2 maximum
};

struct CriticalHeights {
  LevelDirections directions;
  std::vector<CriticalHeight> points;
  /// Middles of boxes that the finest level does not decide, or that are as small as rounding.
  std::vector<Point> undecided;

  bool is_complete() const { return undecided.empty(); }
  std::array<std::size_t, 3> counts() const;
  /// Minima - saddles + maxima: the surface's, where the points are complete.
  long euler_characteristic() const;
};

/// @param cover  of the zero set
CriticalHeights critical_heights(const Function& f, const Cover& cover,
                                 const LevelDirections& directions, const geometry::Run& run);

}  // namespace morskin::implicit
