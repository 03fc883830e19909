#include "morse/distance_equation.h"

#include <algorithm>
#include <cmath>

namespace morskin::morse {

namespace {

/// The equation relative to one pole: a^2 / s^2 - b^2 / (2 - s)^2 = w for s < 1. With s = 1 - m its
/// roots are those with m > 0; with s = 1 + m, a and b exchanged and w negated, those with m < 0.
/// Near the pole s keeps the digits that 1 - m would lose, and 2 - s > 1 loses none.
struct Half {
  double a, b, w;

  struct Value {
    double value, slope;
  };
  Value at(double s) const {
    const double p = a / s, q = b / (2 - s);
    return {p * p - q * q - w, -2 * (p * p / s + q * q / (2 - s))};
  }
};

/// The root of a monotone function of a positive variable: Newton's method inside a bracket, with
/// bisection (geometric, while its ends differ much) where a step leaves it or does not shrink.
///
/// @param falls  whether the function falls from low to high
template <class Function>
double root_between(const Function& function, bool falls, double low, double high) {
  // Bisection alone takes 11 steps for the exponent and 53 for the mantissa.
  constexpr int max_steps = 128;
  const auto middle = [&] {
    return high > 4 * low ? std::sqrt(low) * std::sqrt(high) : low + (high - low) / 2;
  };
  double s = middle(), last_step = high - low;
  for (int i = 0; i < max_steps; ++i) {
    const auto [value, slope] = function(s);
    const double newton = value / slope;
    if (value == 0 || std::abs(newton) <= std::ldexp(s, -53)) return s;
    ((value > 0) == falls ? low : high) = s;
    double next = s - newton;
    if (!(next > low && next < high) || 2 * std::abs(newton) > last_step) next = middle();
    last_step = std::abs(next - s);
    if (last_step <= std::ldexp(s, -53)) return next;
    s = next;
  }
  return s;
}

/// Visits the roots s < 1 of a half with a > 0; s = 1 counts only for one of the two halves.
/// @param visit  visit(s)
template <class Visit>
void for_each_root(const Half& half, bool with_one, double rounding, const Visit& visit) {
  const auto [a, b, w] = half;
  const double A = a * a, B = b * b;
  // 0 < s <= 1, between the poles: falls from infinity to A - B, so the two halves together have
  // one root there. At s = a / sqrt(w + B) the value is still at least w.
  if (with_one ? w >= A - B : w > A - B) {
    const double low = std::min(1.0, a / std::sqrt(w + B));
    visit(root_between([&](double s) { return half.at(s); }, true, low, 1.0));
  }
  // s = -q < 0, beyond the pole.
  const auto beyond = [&](double q) {
    const auto [value, slope] = half.at(-q);
    return Half::Value{value, -slope};
  };
  if (b <= a) {  // falls from infinity to 0
    if (w > 0) visit(-root_between(beyond, true, a / std::sqrt(w + B / 4), a / std::sqrt(w)));
    return;
  }
  // Falls from infinity to the turning point, ((2 + q) / q)^3 = B / A, and rises to 0 after it.
  const double root_a = std::cbrt(A), root_b = std::cbrt(B);
  const double difference = (b - a) * (b + a) / (root_b * (root_b + root_a) + root_a * root_a);
  const double turn = 2 * root_a / difference;
  const double lowest = std::max(-difference * difference * difference / 4, -B / 4);
  // The error of the value at the turning point for errors `rounding` of a and b.
  const double uncertain = 2 * rounding * (a / (turn * turn) + b / ((2 + turn) * (2 + turn)));
  if (std::abs(w - lowest) <= uncertain) {
    visit(-turn);
  } else if (w > lowest) {
    visit(-root_between(beyond, true, std::min(turn, a / std::sqrt(w + B / 4)),
                        w > 0 ? std::min(turn, a / std::sqrt(w)) : turn));
    if (w < 0) visit(-root_between(beyond, false, turn, std::max(turn, b / std::sqrt(-w))));
  }
}

/// The same for a half with a = 0, whose pole has no residue.
template <class Visit>
void for_each_root_without_pole(const Half& half, bool with_one, const Visit& visit) {
  const double B = half.b * half.b;
  if (half.w < 0 && (with_one ? half.w >= -B : half.w > -B)) {
    visit(std::min(1.0, 2 - half.b / std::sqrt(-half.w)));
  }
}

}  // namespace

MeridianPoints distance_equation(double across, double along, double W, double rounding) {
  MeridianPoints points;
  const Half near_plus{across, std::abs(along), W}, near_minus{std::abs(along), across, -W};
  const auto plus = [&](double s) {
    points.add({s, 2 - s, across == 0 ? 0 : across / s, along / (2 - s), false});
  };
  const auto minus = [&](double s) {
    points.add({2 - s, s, across / (2 - s), along == 0 ? 0 : along / s, false});
  };
  if (across > 0) {
    for_each_root(near_plus, true, rounding, plus);
  } else {
    for_each_root_without_pole(near_plus, true, plus);
    // m = 1: the part across is free, and G = 0 gives its length.
    const double square = W + along * along / 4;
    if (square > 0) points.add({0, 2, std::sqrt(square), along / 2, true});
  }
  if (along != 0) {
    for_each_root(near_minus, false, rounding, minus);
  } else {
    for_each_root_without_pole(near_minus, false, minus);
    // m = -1, the same along the axis: two points.
    const double square = across * across / 4 - W;
    if (square > 0) {
      points.add({2, 0, across / 2, std::sqrt(square), false});
      points.add({2, 0, across / 2, -std::sqrt(square), false});
    }
  }
  return points;
}

}  // namespace morskin::morse
