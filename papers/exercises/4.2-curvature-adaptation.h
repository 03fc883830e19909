#pragma once

#include "papers/exercises/course.h"

/// Predict. Triangles on a lone ball if all were equilateral with edges of 0.181 rho. The test lets
/// you be 20 % off what the program lays.
Number triangles_on_a_ball = unanswered;

/// Run. `benzene.pdb` with -C 0.03: how many triangles?
Count benzene_triangles = unanswered;

/// Explain. r_a / rho in closed form, with the factor 2 that the paper lost.
Formula<double(double C, double Q)> disk_share = unanswered;
