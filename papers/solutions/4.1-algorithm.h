#pragma once

#include "papers/exercises/course.h"

// Minima and maxima change places.
Counts from_above = {{7, 12, 5}};

// Those of the surviving minima that lie below the level and of the maxima above it. One front
// lays 26: one for each surviving minimum.
Count bowls_of_both = 27;

// f(x + e) = f(x) + gradient . e + c |e|^2, largest for e along the gradient.
Formula<double(double g, double c, double d)> largest_rise = [](double g, double c, double d) {
  return d * (g + c * d);
};
