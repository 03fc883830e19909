#pragma once

/// Boxes that cover a zero set, found by exclusion: in all others f is proved to have no zero.

#include <optional>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/run.h"
#include "implicit/function.h"
#include "surface/bounding_ball.h"

namespace morskin::implicit {

/// The zero set is singular, or so nearly that boxes far smaller than it do not tell.
class SingularLevel : public geometry::RefusedInput {
 public:
  SingularLevel(const std::string& text, const Point& at, double value)
      : geometry::RefusedInput(text), place(at), critical_value(value) {}

  Point place;            ///< of f's critical point
  double critical_value;  ///< of f there
};

/// A box in which the gradient is proved to turn so little that f is monotone along one axis.
struct CoverBox {
  Box box;
  double min_gradient, max_gradient;  ///< bounds on |grad f| over the box
  int axis;                           ///< along which f is monotone
  double slant;                       ///< upper bound on |grad f| over its part along the axis

  /// Bound on the area of the zero set in the box, Angstrom^2.
  double max_area() const { return 4.001 * box.half * box.half * slant; }
};

struct Cover {
  std::vector<CoverBox> boxes;

  double max_gradient() const;
  /// A ball that contains all boxes.
  surface::BoundingBall bounding_ball() const;
};

/// Covers the zero set in a cube. Afterwards it is proved to be a smooth surface there, without a
/// singular point, and closed.
/// @param cube  its half a power of two, its centre on a grid so coarse that halving rounds nothing
/// @param inner  of the cube of half the size about the same centre, where there is one already
/// @return nothing where a zero may lie on the cube's boundary or f is not positive there
/// @throws SingularLevel
/// @throws geometry::RefusedInput  where f has no bounds, or such wide ones that they tell nothing
std::optional<Cover> cover(const Function& f, const Box& cube, const std::optional<Cover>& inner,
                           const geometry::Run& run);

}  // namespace morskin::implicit
