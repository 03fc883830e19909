#pragma once

/// A number with its first and second derivatives in x, y and z, and the rules to compute with
/// such. The numbers are doubles, or intervals; then so are the derivatives.

#include <array>
#include <cmath>
#include <cstddef>

#include "implicit/interval.h"

namespace morskin::implicit {

template <class T>
using Triple = std::array<T, 3>;

/// Where row i, column j of a symmetric matrix stands: xx, xy, xz, yy, yz, zz.
inline constexpr std::array<std::array<std::size_t, 3>, 3> symmetric_index{
    {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};

/// @tparam order  of the derivatives, 1 or 2
template <class T, int order>
struct Jet {
  T value{};
  Triple<T> gradient{};
  std::array<T, order == 2 ? 6 : 0> hessian{};  ///< by symmetric_index

  Jet() = default;
  Jet(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor): a number
  static Jet variable(const T& value, std::size_t axis) {
    Jet result;
    result.value = value;
    result.gradient[axis] = T(1.0);
    return result;
  }
};

inline double square(double x) { return x * x; }

template <class T, int order>
Jet<T, order> operator+(const Jet<T, order>& a, const Jet<T, order>& b) {
  Jet<T, order> r;
  r.value = a.value + b.value;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = a.gradient[i] + b.gradient[i];
  for (std::size_t k = 0; k < r.hessian.size(); ++k) r.hessian[k] = a.hessian[k] + b.hessian[k];
  return r;
}
template <class T, int order>
Jet<T, order> operator-(const Jet<T, order>& a) {
  Jet<T, order> r;
  r.value = -a.value;
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = -a.gradient[i];
  for (std::size_t k = 0; k < r.hessian.size(); ++k) r.hessian[k] = -a.hessian[k];
  return r;
}
template <class T, int order>
Jet<T, order> operator-(const Jet<T, order>& a, const Jet<T, order>& b) {
  return a + (-b);
}
template <class T, int order>
Jet<T, order> operator*(const Jet<T, order>& a, const Jet<T, order>& b) {
  Jet<T, order> r;
  r.value = a.value * b.value;
  for (std::size_t i = 0; i < 3; ++i) {
    r.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
    if constexpr (order == 2) {
      for (std::size_t j = i; j < 3; ++j) {
        const std::size_t k = symmetric_index[i][j];
        r.hessian[k] = a.hessian[k] * b.value + a.value * b.hessian[k] +
                       (a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i]);
      }
    }
  }
  return r;
}

/// g(a), from g and its first two derivatives at a's value.
template <class T, int order>
Jet<T, order> chain(const Jet<T, order>& a, const T& g, const T& first, const T& second) {
  Jet<T, order> r;
  r.value = g;
  for (std::size_t i = 0; i < 3; ++i) {
    r.gradient[i] = first * a.gradient[i];
    if constexpr (order == 2) {
      for (std::size_t j = i; j < 3; ++j) {
        const std::size_t k = symmetric_index[i][j];
        const T product = i == j ? square(a.gradient[i]) : a.gradient[i] * a.gradient[j];
        r.hessian[k] = first * a.hessian[k] + second * product;
      }
    }
  }
  return r;
}

template <class T, int order>
Jet<T, order> square(const Jet<T, order>& a) {
  return chain(a, square(a.value), T(2.0) * a.value, T(2.0));
}
template <class T, int order>
Jet<T, order> operator/(const Jet<T, order>& a, const Jet<T, order>& b) {
  const T inverse = T(1.0) / b.value, squared = square(inverse);
  return a * chain(b, inverse, -squared, T(2.0) * squared * inverse);
}
template <class T, int order>
Jet<T, order> sqrt(const Jet<T, order>& a) {
  using std::sqrt;
  const T root = sqrt(a.value), first = T(0.5) / root;
  return chain(a, root, first, -(first / (T(2.0) * a.value)));
}
template <class T, int order>
Jet<T, order> exp(const Jet<T, order>& a) {
  using std::exp;
  const T g = exp(a.value);
  return chain(a, g, g, g);
}
template <class T, int order>
Jet<T, order> log(const Jet<T, order>& a) {
  using std::log;
  const T inverse = T(1.0) / a.value;
  return chain(a, log(a.value), inverse, -square(inverse));
}
template <class T, int order>
Jet<T, order> sin(const Jet<T, order>& a) {
  using std::cos;
  using std::sin;
  const T s = sin(a.value);
  return chain(a, s, cos(a.value), -s);
}
template <class T, int order>
Jet<T, order> cos(const Jet<T, order>& a) {
  using std::cos;
  using std::sin;
  const T c = cos(a.value);
  return chain(a, c, -sin(a.value), -c);
}

/// A number to a whole power of at least 0, by squaring.
template <class T>
T power(const T& a, int exponent) {
  if (exponent == 0) return T(1.0);
  if (exponent == 1) return a;
  const T even = square(power(a, exponent / 2));
  return exponent % 2 == 0 ? even : even * a;
}

}  // namespace morskin::implicit
