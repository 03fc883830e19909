#pragma once

#include "papers/exercises/course.h"

/// Predict. minima - saddles + maxima of the squared distance from (1, 9, 2) on the cube's skin,
/// whose height gives 6 - 8 + 6.
Count distance_sum = unanswered;

/// Run. `1grm_model1.pdb`, swept with --function distance:5,2,1: how many saddles has the distance?
Count distance_saddles = unanswered;

/// Explain. The squared distance f from a point R away along -V. Scale and shift it so that it
/// tends to the height along V as R grows: from f and R.
Formula<double(double f, double R)> as_height = unanswered;
