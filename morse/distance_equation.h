#pragma once

/// Lagrange's equation of a squared distance on one quadric patch.
///
/// With p the origin of the distance, d = p - centre and u = x - centre, a critical point satisfies
/// u - d = mu M u and G = 0. Let m = mu sign. Across the patch's axis u = d / (1 - m), along it
/// u = d / (1 + m), which leaves one equation in m,
///
///     A / (1 - m)^2 - B / (1 + m)^2 = W,
///
/// A and B the squares of d across and along the axis, W = sign w/2: a quartic, solved without its
/// coefficients. Between its poles and its turning points, which have a closed form, the left side
/// is monotone. Derived in papers/3.1-morse-functions.md.

#include <array>
#include <cstddef>

namespace morskin::morse {

/// A critical point in the half plane through the axis and p.
struct MeridianPoint {
  double one_minus_m, one_plus_m;  ///< each with a small relative error; their sum is 2
  double across, along;            ///< u: towards p across the axis (may be negative), and along it
  bool is_circle;  ///< p on the axis, m = 1: the whole circle of radius `across` is critical
};

/// At most four: the equation is a quartic, and a pole without residue counts for two roots.
class MeridianPoints {
 public:
  void add(const MeridianPoint& point) { points_[size_++] = point; }
  std::size_t size() const { return size_; }
  const MeridianPoint* begin() const { return points_.data(); }
  const MeridianPoint* end() const { return points_.data() + size_; }

 private:
  std::array<MeridianPoint, 4> points_{};
  std::size_t size_ = 0;
};

/// All critical points of one quadric, none missed.
///
/// @param across    |d| across the axis, Angstrom, >= 0; exactly 0 when p is on the axis.
/// @param along     d along the axis, signed; exactly 0 when p is in the plane of symmetry.
/// @param W         sign w/2, Angstrom^2.
/// @param rounding  error of `across` and `along`, Angstrom. Where it decides whether a pair of
///                  points exists, the result has one point, where the two would coincide.
MeridianPoints distance_equation(double across, double along, double W, double rounding);

}  // namespace morskin::morse
