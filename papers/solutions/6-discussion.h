#pragma once

#include "papers/exercises/course.h"

// The Euler characteristic belongs to the surface, not to the function.
Count distance_sum = 4;

Count distance_saddles = 142;

// |x + R V|^2 = |x|^2 + 2 R V . x + R^2.
Formula<double(double f, double R)> as_height = [](double f, double R) {
  return (f - R * R) / (2 * R);
};
