#pragma once

// Inside orthocentre: vectors with exact coordinates, for simplices so flat that rounding would
// make their normals and orthocentres meaningless.

#include <array>

#include "geometry/expansion.h"
#include "geometry/point.h"
#include "skin/orthocentre.h"

namespace morskin::skin {

using geometry::Expansion;
/// Right to the last bit or two.
inline long double rounded(const Expansion& x) {
  long double sum = 0;
  for (const double component : x.components()) sum += component;  // smallest first
  return sum;
}

class ExactVector {
 public:
  ExactVector() = default;
  /// b - a
  ExactVector(const geometry::Point& a, const geometry::Point& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      x_[k] = Expansion::difference(b[axis], a[axis]);
    }
  }

  Expansion dot(const ExactVector& v) const {
    return x_[0] * v.x_[0] + x_[1] * v.x_[1] + x_[2] * v.x_[2];
  }
  ExactVector cross(const ExactVector& v) const {
    ExactVector result;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      result.x_[k] = x_[i] * v.x_[j] - x_[j] * v.x_[i];
    }
    return result;
  }
  Wide rounded() const {
    return {skin::rounded(x_[0]), skin::rounded(x_[1]), skin::rounded(x_[2])};
  }

  friend ExactVector operator+(const ExactVector& a, const ExactVector& b) {
    ExactVector result;
    for (std::size_t k = 0; k < 3; ++k) result.x_[k] = a.x_[k] + b.x_[k];
    return result;
  }
  friend ExactVector operator*(const Expansion& factor, const ExactVector& v) {
    ExactVector result;
    for (std::size_t k = 0; k < 3; ++k) result.x_[k] = factor * v.x_[k];
    return result;
  }

 private:
  std::array<Expansion, 3> x_;
};

}  // namespace morskin::skin
