#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/predicates.h"

/// The tiers of the exact predicates, for tests, benchmarks and inlined hot paths. nullopt means
/// "undecided in this tier", never zero. u = 2^-53 is the unit roundoff.
namespace morskin::geometry::internal {

/// Determinants over any type with +, - and *, row-major.
template <class Number>
Number determinant(const std::array<std::array<Number, 1>, 1>& m) {
  return m[0][0];
}

template <class Number>
Number determinant(const std::array<std::array<Number, 2>, 2>& m) {
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

template <class Number>
Number determinant(const std::array<std::array<Number, 3>, 3>& m) {
  return (m[1][0] * m[2][1] - m[1][1] * m[2][0]) * m[0][2] +
         (m[2][0] * m[0][1] - m[2][1] * m[0][0]) * m[1][2] +
         (m[0][0] * m[1][1] - m[0][1] * m[1][0]) * m[2][2];
}

/// Laplace's expansion by pairs of rows: minors of columns 0, 1 times those of columns 2, 3.
template <class Number>
Number determinant(const std::array<std::array<Number, 4>, 4>& m) {
  const auto left = [&m](std::size_t i, std::size_t j) -> Number {
    return m[i][0] * m[j][1] - m[i][1] * m[j][0];
  };
  const auto right = [&m](std::size_t i, std::size_t j) -> Number {
    return m[i][2] * m[j][3] - m[i][3] * m[j][2];
  };
  return ((left(0, 1) * right(2, 3) + left(2, 3) * right(0, 1)) -
          (left(0, 2) * right(1, 3) + left(1, 3) * right(0, 2))) +
         (left(0, 3) * right(1, 2) + left(1, 2) * right(0, 3));
}

/// The sign of a number within `error` of `value`.
inline std::optional<Sign> sign_beyond(double value, double error) {
  if (std::fabs(value) > error) return value > 0 ? Sign::Positive : Sign::Negative;
  return std::nullopt;
}

inline double largest(double a, double b, double c) {
  return std::max(std::max(std::fabs(a), std::fabs(b)), std::fabs(c));
}

/// A vector of two doubles, and its shuffles (GCC and Clang).
typedef double Pair __attribute__((vector_size(16)));
typedef std::int64_t PairBits __attribute__((vector_size(16)));

inline Pair firsts(Pair a, Pair b) { return __builtin_shufflevector(a, b, 0, 2); }
inline Pair seconds(Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 3); }
inline Pair swapped(Pair a) { return __builtin_shufflevector(a, a, 1, 0); }
inline Pair larger(Pair a, Pair b) { return a > b ? a : b; }
inline Pair magnitude(Pair a) {
  constexpr std::int64_t all_but_sign = 0x7fffffffffffffff;
  return reinterpret_cast<Pair>(reinterpret_cast<PairBits>(a) &
                                PairBits{all_but_sign, all_but_sign});
}

/// Tier 1 of `orientation`: plain doubles and an error bound from the largest differences.
///
/// Each of the 6 products of the determinant is at most XYZ and suffers at most 8 roundings (3
/// differences, 2 in the minor, 1 product, 2 sums): error <= 48 u XYZ (1 + tiny); 52 is used.
inline std::optional<Sign> filtered_orientation(const Point& a, const Point& b, const Point& c,
                                                const Point& d) {
  const double ax = a.x() - d.x(), ay = a.y() - d.y(), az = a.z() - d.z();
  const double bx = b.x() - d.x(), by = b.y() - d.y(), bz = b.z() - d.z();
  const double cx = c.x() - d.x(), cy = c.y() - d.y(), cz = c.z() - d.z();
  const double bound =
      52 * 0x1p-53 * largest(ax, bx, cx) * largest(ay, by, cy) * largest(az, bz, cz);
  using Rows = std::array<std::array<double, 3>, 3>;
  return sign_beyond(determinant<double>(Rows{{{ax, ay, az}, {bx, by, bz}, {cx, cy, cz}}}), bound);
}

/// `orientation` with its first tier inlined.
inline Sign fast_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (const auto sign = filtered_orientation(a, b, c, d)) return *sign;
  return orientation(a, b, c, d);
}

/// Tier 2: 128-bit integers, if the exact differences fit 40 bits at a common scale.
std::optional<Sign> integer_orientation(const Point& a, const Point& b, const Point& c,
                                        const Point& d);
/// Tier 3, always exact.
Sign expanded_orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// The sign of the determinant with rows (p - e, |p - e|^2 - (w_p - w_e)), p = a, b, c, d. Positive
/// means inside if orientation(a, b, c, d) is positive. Tier 1: as `filtered_orientation`.
///
/// 24 products of at most XYZH each, H bounding the last column before cancellation; at most 19
/// roundings: 3 differences, 6 in the height, 2 and 2 in the minors, 1 product, 5 sums. Error
/// <= 456 u XYZH (1 + tiny); 480 is used.
inline std::optional<Sign> filtered_orthosphere(const WeightedPoint& a, const WeightedPoint& b,
                                                const WeightedPoint& c, const WeightedPoint& d,
                                                const WeightedPoint& e) {
  // Two doubles at a time, in half the time of the template. Suffixes: ab has the values of rows a
  // and b; p1 is (x, y) of a row and p2 its (z, w).
  const Pair e1{e.position.x(), e.position.y()}, e2{e.position.z(), e.weight};
  const Pair a1 = Pair{a.position.x(), a.position.y()} - e1;
  const Pair b1 = Pair{b.position.x(), b.position.y()} - e1;
  const Pair c1 = Pair{c.position.x(), c.position.y()} - e1;
  const Pair d1 = Pair{d.position.x(), d.position.y()} - e1;
  const Pair a2 = Pair{a.position.z(), a.weight} - e2, b2 = Pair{b.position.z(), b.weight} - e2;
  const Pair c2 = Pair{c.position.z(), c.weight} - e2, d2 = Pair{d.position.z(), d.weight} - e2;
  const Pair x_ab = firsts(a1, b1), y_ab = seconds(a1, b1), z_ab = firsts(a2, b2);
  const Pair x_cd = firsts(c1, d1), y_cd = seconds(c1, d1), z_cd = firsts(c2, d2);
  const Pair h_ab = (x_ab * x_ab + y_ab * y_ab + z_ab * z_ab) - seconds(a2, b2);
  const Pair h_cd = (x_cd * x_cd + y_cd * y_cd + z_cd * z_cd) - seconds(c2, d2);
  const Pair x_dc = swapped(x_cd), y_dc = swapped(y_cd), z_dc = swapped(z_cd), h_dc = swapped(h_cd);
  const Pair x_ac = firsts(a1, c1), y_ac = seconds(a1, c1), z_ac = firsts(z_ab, z_cd);
  const Pair x_bd = firsts(b1, d1), y_bd = seconds(b1, d1), z_bd = seconds(z_ab, z_cd);
  const Pair h_ac = firsts(h_ab, h_cd), h_bd = seconds(h_ab, h_cd);
  // Minors of two rows, left in x and y, right in z and h; a product pairs complementary rows.
  const Pair ab_cd = (x_ac * y_bd - y_ac * x_bd) * swapped(z_ac * h_bd - h_ac * z_bd);
  const Pair ac_bd = (x_ab * y_cd - y_ab * x_cd) * swapped(z_ab * h_cd - h_ab * z_cd);
  const Pair ad_bc = (x_ab * y_dc - y_ab * x_dc) * swapped(z_ab * h_dc - h_ab * z_dc);
  const Pair determinant_halves = (ab_cd - ac_bd) + ad_bc;
  const Pair xy =
      larger(larger(magnitude(a1), magnitude(b1)), larger(magnitude(c1), magnitude(d1)));
  const Pair zw =
      larger(larger(magnitude(a2), magnitude(b2)), larger(magnitude(c2), magnitude(d2)));
  const double x = xy[0], y = xy[1], z = zw[0], w = zw[1];
  const double bound = 480 * 0x1p-53 * x * y * z * (x * x + y * y + z * z + w);
  return sign_beyond(determinant_halves[0] + determinant_halves[1], bound);
}

/// Tier 2: 128-bit integers, if the exact differences fit 24 bits at a common scale.
std::optional<Sign> integer_orthosphere(const WeightedPoint& a, const WeightedPoint& b,
                                        const WeightedPoint& c, const WeightedPoint& d,
                                        const WeightedPoint& e);
/// Tier 3: 106-bit numbers, for near ties of coordinates with all 53 bits in use.
std::optional<Sign> refined_orthosphere(const WeightedPoint& a, const WeightedPoint& b,
                                        const WeightedPoint& c, const WeightedPoint& d,
                                        const WeightedPoint& e);
/// Tier 4, always exact; Zero is a tie.
Sign expanded_orthosphere(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                          const WeightedPoint& d, const WeightedPoint& e);
/// Tier 5: the sign of a tie under symbolic perturbation; never Zero.
///
/// @pre expanded_orthosphere gave Zero; orientation(a, b, c, d) == Sign::Positive.
Sign symbolic_orthosphere(const std::array<const Point*, 5>& points,
                          const std::array<AtomId, 5>& ids);

}  // namespace morskin::geometry::internal
