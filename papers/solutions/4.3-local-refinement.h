#pragma once

#include "papers/exercises/course.h"

// One becomes three.
Count triangles_of_an_insertion = 2;

Count insertions = 2665;

// On the circle through a, b, c the far corner sees ab under pi minus the angle at c; inside it
// sees ab under more.
Formula<bool(double one, double other)> flip = [](double one, double other) {
  return one + other > M_PI;
};
