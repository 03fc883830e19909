#pragma once

/// How a point moves with the growing skin (papers/5-dynamic.md): normal to it, at speed
/// 1 / (4 rho) in t. With u = x - centre cut into u_n along the dual cell and u_s along the
/// simplex, inside one mixed cell
///
///     x(E) = centre + E u_n + u_s / E,     E^2 |u_n|^2 - |u_s|^2 / E^2 = (w + t) / 2,
///
/// so the position at any t is in closed form: radii in spheres, hyperbolas elsewhere. The curve
/// goes on in the next cell with the same tangent.

#include "skin/level_set.h"

namespace morskin::baselines {

using geometry::CellId;
using skin::LevelSet;
using skin::Patch;
using skin::Point;
using skin::SkinSurface;
using skin::Vector;
using surface::SurfacePoint;

/// The part of a trajectory in one mixed cell.
class Trajectory {
 public:
  Trajectory() = default;
  /// @param x     a point of the skin at time `time`, in `cell`
  Trajectory(const SkinSurface& skin, const Point& x, CellId cell, double time);

  CellId cell() const { return cell_; }
  double begins() const { return begins_; }
  double leaves() const { return leaves_; }  ///< infinity if it stays in the cell

  /// The point of the surface at time t. @pre begins() <= t <= leaves(), but for
  /// rounding.
  SurfacePoint at(const SkinSurface& skin, double t) const;

  /// The part that contains time t >= begins(), by walking on over cell walls.
  Trajectory followed_to(const SkinSurface& skin, double t) const;

 private:
  /// E at the level g = (w + t) / 2, in the form that does not cancel.
  double stretch(double g) const;
  void find_exit(const SkinSurface& skin);

  CellId cell_;
  CellId beyond_;  ///< the cell after this one
  double begins_ = 0, leaves_ = 0;
  double exit_stretch_ = 1;         ///< E where the cell ends
  Vector across_ = Vector::Zero();  ///< u_n at the beginning
  Vector along_ = Vector::Zero();   ///< u_s
  double across_squared_ = 0, along_squared_ = 0;
};

}  // namespace morskin::baselines
