#include "implicit/linear_algebra.h"

#include <Eigen/LU>

namespace morskin::implicit {

Krawczyk krawczyk(const Box& box, const SystemBounds& bounds) {
  Krawczyk result;
  Eigen::Matrix3d middle;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!bounds.jacobian[i][j].is_finite()) return result;
      middle(static_cast<int>(i), static_cast<int>(j)) = bounds.jacobian[i][j].middle();
    }
  }
  const Eigen::Matrix3d Y = middle.inverse();  // any matrix would do
  if (!Y.allFinite()) return result;
  const Interval offset = Interval::about(0, box.half);
  bool is_inside = true;
  for (int i = 0; i < 3; ++i) {
    Interval k = box.centre[i];
    for (std::size_t j = 0; j < 3; ++j) {
      Interval entry = static_cast<std::size_t>(i) == j ? 1.0 : 0.0;  // of 1 - Y J
      for (int l = 0; l < 3; ++l) {
        entry = entry - Interval(Y(i, l)) * bounds.jacobian[static_cast<std::size_t>(l)][j];
      }
      k += entry * offset;
      k = k - Interval(Y(i, static_cast<int>(j))) * bounds.at_centre[j];
    }
    const Interval side{Interval::up(box.centre[i] - box.half),
                        Interval::down(box.centre[i] + box.half)};  // no more than the side
    is_inside = is_inside && k.low > side.low && k.high < side.high;
    const Interval outer = box.side(i);
    if (k.high < outer.low || k.low > outer.high) {
      result.verdict = Krawczyk::Verdict::None;
      return result;
    }
    result.zeros[static_cast<std::size_t>(i)] = intersection(k, outer);
  }
  if (is_inside) result.verdict = Krawczyk::Verdict::One;
  return result;
}

Box box_about(const Triple<Interval>& x) {
  Box box{Point(x[0].middle(), x[1].middle(), x[2].middle()), 0};
  for (const Interval& side : x) box.half = std::max(box.half, side.radius());
  return box;
}

}  // namespace morskin::implicit
