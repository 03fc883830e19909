#pragma once

#include "geometry/point.h"
#include "geometry/predicates.h"

namespace morskin::support {

/// |q - z|^2 - w, with eleven bits more than doubles have: an oracle for powers in doubles.
inline long double power(const geometry::WeightedPoint& atom, const geometry::Point& q) {
  long double square = 0;
  for (int k = 0; k < 3; ++k) {
    const long double d = static_cast<long double>(atom.position[k]) - q[k];
    square += d * d;
  }
  return square - atom.weight;
}

}  // namespace morskin::support
