#pragma once

#include "papers/exercises/course.h"

/// Predict. A closed mesh of a torus has 5,000 vertices: how many triangles?
Count torus_triangles = unanswered;

/// Run. `9dna.pdb`, --fronts 1: how many corners are winged?
Count wings = unanswered;

/// Explain. Circumradius of a fan triangle: two sides r with an angle phi (radians) between.
Formula<double(double r, double phi)> fan_circumradius = unanswered;
