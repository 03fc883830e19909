#pragma once

#include "papers/exercises/course.h"

// Each triangle has three edges, each edge two triangles: V - 3F/2 + F = 0.
Count torus_triangles = 10000;

Count wings = 2721;

// The third side is 2 r sin(phi/2); by the law of sines it is 2 R sin(phi). With r = 0.181 rho this
// is 0.132 rho, the bound in [U], at cos(phi/2) = 0.181 / 0.264: at 93 degrees.
Formula<double(double r, double phi)> fan_circumradius = [](double r, double phi) {
  return r / (2 * std::cos(phi / 2));
};
