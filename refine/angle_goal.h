#pragma once

/// What smoothing asks of a triangle's angles, and how far a triangle is from it.

#include <algorithm>
#include <cmath>

#include "refine/names.h"

namespace morskin::refine {

class AngleGoal {
 public:
  /// No angle below one bound, none above another, degrees.
  /// @pre 0 <= min_deg <= 60, 90 <= max_deg <= 180
  AngleGoal(double min_deg, double max_deg = 180)
      : min_squared_sine_(squared_sine(min_deg)), max_squared_sine_(squared_sine(max_deg)) {}

  /// The smallest angle asked for where nobody asks.
  static double usual_deg(const Sizing& sizing) {
    return sizing.C <= Sizing::largest_proved_C ? 35 : certify::guaranteed_angle_deg;
  }
  /// A smallest angle, and the largest that goes with it: 35 degrees alone would allow 110.
  static AngleGoal with(double min_deg, const Sizing& sizing) {
    const bool is_bounded = min_deg >= 35 && sizing.C <= Sizing::largest_proved_C;
    return {min_deg, is_bounded ? 105. : 180.};
  }

  /// One that leaves room: a tenth more of the squared sines, as far as there is more.
  AngleGoal stricter() const {
    AngleGoal goal = *this;
    goal.min_squared_sine_ *= 1.1;
    goal.max_squared_sine_ = std::min(1.0, goal.max_squared_sine_ * 1.1);
    return goal;
  }

  /// From 0 to 1 and above, where both bounds are kept: the squared sine of the angle that breaks
  /// one most, over the bound's. NaN for two corners in one point, which then counts as met.
  double quality(const Point& a, const Point& b, const Point& c) const {
    const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
    return quality((b - a).cross(c - a).squaredNorm(), ab, bc, ca);
  }
  /// The same.
  /// @param nn  square of twice the area
  /// @param ab, bc, ca  squares of the edges' lengths
  double quality(double nn, double ab, double bc, double ca) const {
    const double shortest = std::min({ab, bc, ca}), longest = std::max({ab, bc, ca});
    // The sine of the angle opposite an edge is twice the area over the product of the others.
    const double scale = nn / (ab * bc * ca);
    const double smallest = scale * shortest / min_squared_sine_;
    const bool is_obtuse = 2 * longest > ab + bc + ca;
    return is_obtuse ? std::min(smallest, scale * longest / max_squared_sine_) : smallest;
  }
  bool is_met(const Mesh& mesh, TriangleId t) const {
    const auto [a, b, c] = mesh.surface.corners(t);
    return !(quality(mesh.position(a), mesh.position(b), mesh.position(c)) < 1);
  }

 private:
  static double squared_sine(double deg) { return std::pow(std::sin(deg * M_PI / 180), 2); }

  double min_squared_sine_, max_squared_sine_;
};

}  // namespace morskin::refine
