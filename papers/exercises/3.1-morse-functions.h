#pragma once

#include "papers/exercises/course.h"

/// Predict. Two balls joined by a neck, lying on their side: minima, saddles, maxima of the height.
Counts dumbbell = unanswered;

/// Run. `1grm_model1.pdb`, the height along (3, 1, 2), before anything is cancelled: how many
/// saddles?
Count saddles = unanswered;

/// Explain. At a critical point x = z + lambda M V. lambda^2 from w/2 and D = V . M V.
Formula<double(double half_weight, double D)> squared_lambda = unanswered;
