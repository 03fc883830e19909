#pragma once

#include "papers/exercises/course.h"

// A minimum under each ball and a maximum on each; the neck's waist is a saddle below, since the
// neck rises towards its middle, and a saddle above. 2 - 2 + 2 = 2, a sphere's.
Counts dumbbell = {{2, 2, 2}};

// The height is another than the default one, so are its points; their sum is not.
Count saddles = 160;

// u = lambda M V, so G = u . M u - w/2 = lambda^2 (M V) . V - w/2, since M M = I. G = 0. The length
// scale is |u|, and that is |lambda|: M keeps lengths, and V has length 1.
Formula<double(double half_weight, double D)> squared_lambda = [](double half_weight, double D) {
  return half_weight / D;
};
