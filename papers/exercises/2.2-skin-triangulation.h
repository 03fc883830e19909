#pragma once

#include "papers/exercises/course.h"

/// Predict. How many times as many triangles does C = 0.04 give as C = 0.08?
Number times_as_many = unanswered;

/// Run. `caffeine.xyz` with -Q 1.73 --angle-goal 0: the bound on the angles that the report prints,
/// degrees.
Number angle_bound_deg = unanswered;

/// Explain. The smallest Q, for a given C, with which an insertion makes no edge too short.
Formula<double(double C)> smallest_Q = unanswered;
