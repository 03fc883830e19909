#pragma once

/// An orthographic camera.

#include <span>

#include "geometry/point.h"

namespace morskin::pictures {

using geometry::Point;
using geometry::Vector;

/// View space has the unit of a pixel in all three directions: x runs right and y down from the
/// picture's top left corner, z towards the eye, 0 at the target.
struct Camera {
  int width = 640, height = 640;  ///< pixels
  Point target = Point::Zero();   ///< in the middle of the picture
  Vector right = Vector::UnitX(), up = Vector::UnitY(), toward = Vector::UnitZ();
  double scale = 1;  ///< pixels per Angstrom

  Vector seen(const Point& p) const {
    const Vector d = scale * (p - target);
    return {width / 2.0 + right.dot(d), height / 2.0 - up.dot(d), toward.dot(d)};
  }
  /// A direction in view space; keeps its length.
  Vector seen_direction(const Vector& v) const { return {right.dot(v), -up.dot(v), toward.dot(v)}; }

  /// The same with the target and the scale at which all points are in view.
  /// @param margin  share of the picture to leave empty on each side
  Camera fitted(std::span<const Point> points, double margin = 0.03) const;
  /// The same view at another size.
  Camera resized(double factor) const;
};

/// @param toward  from the target to the eye, of any length
/// @param up      upwards in the picture; replaced if it is parallel to `toward`
Camera camera_from(const Vector& toward, const Vector& up, int width, int height);

}  // namespace morskin::pictures
