#include "geometry/orthosphere.h"

#include <cassert>
#include <optional>

#include "geometry/predicates_internal.h"

namespace morskin::geometry {
namespace {

/// A double with a bound on its error. The factor in `sign` covers the rounding of the bound
/// itself, a few u in each of at most twenty steps.
struct Bounded {
  double value = 0;
  double error = 0;

  static Bounded difference(double a, double b) { return {a - b, 0x1p-53 * std::fabs(a - b)}; }
  std::optional<Sign> sign() const { return internal::sign_beyond(value, error * (1 + 0x1p-40)); }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double sum = a.value + b.value;
    return {sum, a.error + b.error + 0x1p-53 * std::fabs(sum)};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    return a + Bounded{-b.value, b.error};
  }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const double product = a.value * b.value;
    return {product, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error +
                         a.error * b.error + 0x1p-53 * std::fabs(product)};
  }
};

/// p - origin, and |p - origin|^2 + w_origin - w_p.
template <class Number>
struct Arm {
  std::array<Number, 3> direction;
  Number height;
};

template <class Number>
Number dot(const Arm<Number>& a, const Arm<Number>& b) {
  return a.direction[0] * b.direction[0] + a.direction[1] * b.direction[1] +
         a.direction[2] * b.direction[2];
}

template <class Number>
Arm<Number> arm(const WeightedPoint& origin, const WeightedPoint& p) {
  Arm<Number> result;
  for (int k = 0; k < 3; ++k) {
    result.direction[static_cast<std::size_t>(k)] =
        Number::difference(p.position[k], origin.position[k]);
  }
  result.height = dot(result, result) + Number::difference(origin.weight, p.weight);
  return result;
}

/// With e_i = p_i - p_0, G = (e_i . e_j) and h_i = |e_i|^2 + w_0 - w_i, the orthocentre is
/// z = p_0 + sum t_i e_i, 2 G t = h. Hence, by bordered determinants,
///   4 det G  w_sigma           = det [ G h ; h^T 4 w_0 ],
///   det G (f_v(z) - f_0(z))    = det [ G h ; (e_i . (v - p_0))^T  h_v ],   and det G > 0.
template <class Number, std::size_t Arms>
struct BorderedGram {
  std::array<Arm<Number>, Arms> arms;
  std::array<std::array<Number, Arms + 1>, Arms + 1> m;

  explicit BorderedGram(std::span<const WeightedPoint> simplex) {
    for (std::size_t i = 0; i < Arms; ++i) arms[i] = arm<Number>(simplex[0], simplex[i + 1]);
    for (std::size_t i = 0; i < Arms; ++i) {
      for (std::size_t j = 0; j < i; ++j) m[i][j] = m[j][i] = dot(arms[i], arms[j]);
      m[i][i] = dot(arms[i], arms[i]);
      m[i][Arms] = arms[i].height;
    }
  }
};

template <class Number, std::size_t Points>
auto weight_sign(std::span<const WeightedPoint> simplex) {
  constexpr std::size_t last = Points - 1;
  BorderedGram<Number, last> gram(simplex);
  for (std::size_t i = 0; i < last; ++i) gram.m[last][i] = gram.arms[i].height;
  gram.m[last][last] = Number::difference(4 * simplex[0].weight, 0);
  return internal::determinant(gram.m).sign();
}

template <class Number, std::size_t Points>
auto power_sign(std::span<const WeightedPoint> simplex, const WeightedPoint& v) {
  constexpr std::size_t last = Points - 1;
  BorderedGram<Number, last> gram(simplex);
  const Arm<Number> to_v = arm<Number>(simplex[0], v);
  for (std::size_t i = 0; i < last; ++i) gram.m[last][i] = dot(gram.arms[i], to_v);
  gram.m[last][last] = to_v.height;
  return internal::determinant(gram.m).sign();
}

template <std::size_t Points>
Sign exact_weight_sign(std::span<const WeightedPoint> simplex) {
  if (const auto sign = weight_sign<Bounded, Points>(simplex)) return *sign;
  return weight_sign<Expansion, Points>(simplex);
}

template <std::size_t Points>
Sign exact_power_sign(std::span<const WeightedPoint> simplex, const WeightedPoint& v) {
  if (const auto sign = power_sign<Bounded, Points>(simplex, v)) return *sign;
  return power_sign<Expansion, Points>(simplex, v);
}

}  // namespace

Sign orthosphere_weight_sign(std::span<const WeightedPoint> simplex) {
  assert(simplex.size() >= 1 && simplex.size() <= 4);
  switch (simplex.size()) {
    case 1:
      return sign_of(simplex[0].weight);
    case 2:
      return exact_weight_sign<2>(simplex);
    case 3:
      return exact_weight_sign<3>(simplex);
    default:
      return exact_weight_sign<4>(simplex);
  }
}

Sign orthosphere_power_sign(std::span<const WeightedPoint> simplex, const WeightedPoint& v) {
  assert(simplex.size() >= 1 && simplex.size() <= 3);
  switch (simplex.size()) {
    case 1:
      return exact_power_sign<1>(simplex, v);
    case 2:
      return exact_power_sign<2>(simplex, v);
    default:
      return exact_power_sign<3>(simplex, v);
  }
}

}  // namespace morskin::geometry
