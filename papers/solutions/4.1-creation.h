#pragma once

#include "papers/exercises/course.h"

// Six to a bowl.
Count triangles_of_bowls = 36;

// One for each minimum that survives.
Count bowls = 234;

// The gradient of a sphere runs to its centre, so a rim point q, at sqrt(rho^2 + r^2) from there,
// goes to rho q/|q|. The hexagon in the plane has edges r; all its corners are scaled alike.
Formula<double(double r, double rho)> rim_edge = [](double r, double rho) {
  return r * rho / std::sqrt(rho * rho + r * r);
};
