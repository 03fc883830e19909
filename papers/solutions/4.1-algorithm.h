#pragma once

#include "papers/exercises/course.h"

// Minima and maxima change places.
Counts of_reversed = {{7, 12, 5}};

// One for each surviving minimum, and more where the skin comes into a box from below.
Count bowls_of_subdomains = 369;

// 2^d in the smallest boxes, and one in every box that has halves: 2^d - 1.
Formula<double(double d)> sweeps = [](double d) { return 2 * std::exp2(d) - 1; };
