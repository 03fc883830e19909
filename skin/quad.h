#pragma once

/// IEEE quadruple precision, computed in software, some fifty times slower than doubles. Every
/// operation is rounded correctly, so an error analysis in units of roundoff holds for both.

#include <Eigen/Core>
#include <cfloat>
#include <cmath>
#include <limits>

namespace morskin::skin {

#if LDBL_MANT_DIG == 113
using Quad = long double;
#else
__extension__ using Quad = __float128;
#endif

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;

/// Above all that squares which are rounded to subnormal doubles can lose.
inline constexpr double underflow = 0x1p-1000;

/// Half the distance from 1 to the next number.
template <class Real>
constexpr Real unit_roundoff = 0x1p-53;
template <>
inline constexpr Quad unit_roundoff<Quad> = 0x1p-113;

template <class Real>
Real magnitude(Real x) {
  return x < 0 ? -x : x;
}

template <class Real>
bool is_finite(Real x) {
  return x - x == 0;
}

/// The largest double that is not above x.
template <class Real>
double rounded_down(Real x) {
  const auto nearest = static_cast<double>(x);
  return Real(nearest) <= x ? nearest
                            : std::nextafter(nearest, -std::numeric_limits<double>::infinity());
}

/// The least double that is not below x.
template <class Real>
double rounded_up(Real x) {
  return -rounded_down(-x);
}

}  // namespace morskin::skin
