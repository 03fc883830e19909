#pragma once

/// A smooth function of space whose zero set is a surface, with proved bounds on it and on its
/// derivatives. Negative inside the body.

#include "geometry/point.h"
#include "implicit/jet.h"

namespace morskin::implicit {

using geometry::Point;
using geometry::Vector;

/// All points no farther than `half` from the centre along each axis.
struct Box {
  Point centre = Point::Zero();
  double half = 0;

  /// @param k  0 to 7
  Box octant(int k) const {
    const double q = half / 2;
    return {centre + q * Vector(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1), q};
  }
  /// Whether the octants' centres are not rounded, so that together they are the box.
  bool is_halved_exactly() const {
    const double q = half / 2;
    const auto c = centre.array();
    return ((c + q) - c == q).all() && (c - (c - q) == q).all();
  }
  /// Whether another lies inside, off the boundary.
  bool contains(const Box& other) const {
    return (centre - other.centre).cwiseAbs().maxCoeff() + other.half < half;
  }
  Interval side(int axis) const { return Interval::about(centre[axis], half); }
  /// Upper bound on the distance from the centre.
  double radius() const { return half * (std::sqrt(3.0) * (1 + 0x1p-40)); }
};

class Function {
 public:
  virtual ~Function();

  struct Value {
    double value;
    Vector gradient;
  };
  /// Value and gradient in plain doubles.
  virtual Value at(const Point& x) const = 0;
  /// Proved bounds on both, all rounding counted.
  virtual Jet<Interval, 1> enclose(const Point& x) const = 0;
  /// Proved bounds over a box, as the expression gives them.
  virtual Jet<Interval, 2> over(const Box& box) const = 0;

  /// The same, sharpened by Taylor's theorem about the centre.
  Jet<Interval, 2> bounds(const Box& box) const;

 protected:
  Function() = default;
  Function(const Function&) = default;
  Function(Function&&) = default;
  Function& operator=(const Function&) = default;
  Function& operator=(Function&&) = default;
};

/// Upper bound on the length of a vector somewhere in a box, and lower bound.
double max_norm(const Triple<Interval>& v);
double min_norm(const Triple<Interval>& v);

inline Interval dot(const Triple<Interval>& v, const Vector& w) {
  return v[0] * w.x() + v[1] * w.y() + v[2] * w.z();
}

}  // namespace morskin::implicit
