#pragma once

#include "papers/exercises/course.h"

/// Predict. Seconds for GramicidinA if the paper's times were linear, from those for pdb7tmn.
Number linear_seconds = unanswered;

/// Run. `amprenavir.pdb`, --fronts 1 --angle-goal 0: the smallest angle, degrees.
Number smallest_angle_deg = unanswered;

/// Explain. The power with which the time grows, from two rows of triangles and seconds.
Formula<double(double n1, double t1, double n2, double t2)> power = unanswered;
