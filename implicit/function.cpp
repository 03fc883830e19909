#include "implicit/function.h"

namespace morskin::implicit {

Function::~Function() = default;

double max_norm(const Triple<Interval>& v) {
  return sqrt(square(v[0]) + square(v[1]) + square(v[2])).high;
}

double min_norm(const Triple<Interval>& v) {
  return sqrt(square(v[0]) + square(v[1]) + square(v[2])).low;
}

Jet<Interval, 2> Function::bounds(const Box& box) const {
  Jet<Interval, 2> result = over(box);
  const Jet<Interval, 1> at_centre = enclose(box.centre);
  const Interval offset = Interval::about(0, box.half);
  Interval value = at_centre.value;
  for (std::size_t i = 0; i < 3; ++i) {
    Interval change;  // of the gradient, from the centre
    for (std::size_t j = 0; j < 3; ++j) {
      const Interval& h = result.hessian[symmetric_index[i][j]];
      change += h * offset;
      const Interval half_product =
          i == j ? Interval(0.5) * h * square(offset) : Interval(0.5) * h * (offset * offset);
      value += half_product;
    }
    value += at_centre.gradient[i] * offset;
    result.gradient[i] = intersection(result.gradient[i], at_centre.gradient[i] + change);
  }
  result.value = intersection(result.value, value);
  return result;
}

}  // namespace morskin::implicit
