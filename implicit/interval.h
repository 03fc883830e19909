#pragma once

/// Intervals with outward rounding: every operation returns an interval that holds all results of
/// the exact operation on numbers of its operands.
///
/// After each operation an end moves by one or two units in its last place, whatever way the
/// processor rounds; so nothing depends on its rounding mode. The functions of the C library (exp,
/// log, sin, cos) move by more: glibc states errors below one unit, and four are allowed for.

#include <algorithm>
#include <cmath>
#include <limits>

namespace morskin::implicit {

/// All x with low <= x <= high. Where an operation has no value, such as a division by zero, the
/// result is the whole line.
struct Interval {
  double low = 0, high = 0;

  Interval() = default;
  Interval(double x) : low(x), high(x) {}  // NOLINT(google-explicit-constructor): a number is one
  /// Either end may be NaN, which stands for infinity.
  Interval(double from, double to)
      : low(std::isnan(from) ? -infinity : from), high(std::isnan(to) ? infinity : to) {}

  static Interval whole() { return {-infinity, infinity}; }
  static Interval about(double middle, double radius) {
    return {down(middle - radius), up(middle + radius)};
  }

  bool contains(double x) const { return low <= x && x <= high; }
  bool is_positive() const { return low > 0; }
  bool is_negative() const { return high < 0; }
  bool is_finite() const { return std::isfinite(low) && std::isfinite(high); }
  double middle() const { return low + (high - low) / 2; }
  /// Upper bound on the distance from middle() to either end.
  double radius() const { return up(std::max(high - middle(), middle() - low)); }
  double width() const { return up(high - low); }
  /// The largest and the smallest absolute value.
  double max_abs() const { return std::max(-low, high); }
  double min_abs() const { return std::max({0.0, low, -high}); }

  /// A number below by at least one unit in the last place, and at most two and `tiny`.
  static double down(double x) {
    if (x == infinity) return std::numeric_limits<double>::max();
    return x - (std::abs(x) * 0x1p-52 + tiny);
  }
  static double up(double x) { return -down(-x); }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// What is added to each step. It is above the rounding of results that underflow, and so large
  /// that the product of two such does not: many processors are slow there.
  static constexpr double tiny = 0x1p-500;
};

inline Interval outward(double low, double high) {
  return {Interval::down(low), Interval::up(high)};
}

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return outward(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return outward(a.low - b.high, a.high - b.low);
}
inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  if (std::isnan(p + q + r + s)) return Interval::whole();  // there are infinite ends
  return outward(std::min(std::min(p, q), std::min(r, s)),
                 std::max(std::max(p, q), std::max(r, s)));
}
inline Interval operator/(const Interval& a, const Interval& b) {
  if (b.contains(0) || !a.is_finite() || !b.is_finite()) return Interval::whole();
  const double p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
  return outward(std::min(std::min(p, q), std::min(r, s)),
                 std::max(std::max(p, q), std::max(r, s)));
}
inline Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }

inline Interval square(const Interval& a) {
  return outward(a.min_abs() * a.min_abs(), a.max_abs() * a.max_abs());
}
/// @pre they meet; of disjoint ones, which rounding alone cannot make, the first
inline Interval intersection(const Interval& a, const Interval& b) {
  const Interval both{std::max(a.low, b.low), std::min(a.high, b.high)};
  return both.low <= both.high ? both : a;
}

namespace internal {
/// Four units in the last place outward, for functions of the C library.
inline Interval around(double low, double high) {
  const auto margin = [](double x) {
    return std::isinf(x) ? 0 : std::abs(x) * 0x1p-50 + Interval::tiny;
  };
  return {Interval::down(low - margin(low)), Interval::up(high + margin(high))};
}
/// Whether an interval may hold a number of the form offset + 2 pi k. Rounding makes it say yes
/// too often, never too seldom.
inline bool may_hold_turn(const Interval& a, double offset) {
  constexpr double turn = 2 * M_PI, doubt = 1e-9;
  const double first = std::ceil((a.low - offset) / turn - doubt);
  return first * turn + offset <= a.high + doubt * turn;
}
}  // namespace internal

/// Of a number below zero there is none.
inline Interval sqrt(const Interval& a) {
  if (a.low < 0) return Interval::whole();
  const Interval roots = outward(std::sqrt(a.low), std::sqrt(a.high));
  return {std::max(0.0, roots.low), roots.high};
}
inline Interval exp(const Interval& a) {
  const Interval result = internal::around(std::exp(a.low), std::exp(a.high));
  return {std::max(0.0, result.low), result.high};
}
inline Interval log(const Interval& a) {
  if (!(a.low > 0)) return Interval::whole();
  return internal::around(std::log(a.low), std::log(a.high));
}
inline Interval cos(const Interval& a) {
  constexpr double largest = 1e6;  // beyond, doubles tell too little of the angle
  if (!(a.max_abs() < largest) || a.high - a.low >= 6) return {-1, 1};
  const auto [low, high] = std::minmax({std::cos(a.low), std::cos(a.high)});
  const Interval ends = internal::around(low, high);
  return {internal::may_hold_turn(a, M_PI) ? -1 : std::max(-1.0, ends.low),
          internal::may_hold_turn(a, 0) ? 1 : std::min(1.0, ends.high)};
}
inline Interval sin(const Interval& a) {
  constexpr double largest = 1e6;
  if (!(a.max_abs() < largest) || a.high - a.low >= 6) return {-1, 1};
  const auto [low, high] = std::minmax({std::sin(a.low), std::sin(a.high)});
  const Interval ends = internal::around(low, high);
  return {internal::may_hold_turn(a, -M_PI / 2) ? -1 : std::max(-1.0, ends.low),
          internal::may_hold_turn(a, M_PI / 2) ? 1 : std::min(1.0, ends.high)};
}

}  // namespace morskin::implicit
