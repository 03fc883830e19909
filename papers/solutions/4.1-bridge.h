#pragma once

#include "papers/exercises/course.h"

// One at each saddle: below it the front arrives from two sides.
Count ring_bridges = 2;

Count touches_outside = 871;

// Across the saddle the surface falls off as y^2/(2 rho) where it bends most: the branches of level
// -d are at y = +-sqrt(2 rho d), 2 sqrt(2 rho d) apart.
Formula<double(double rho, double edge)> depth_of_gap = [](double rho, double edge) {
  return edge * edge / (8 * rho);
};
