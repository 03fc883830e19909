#pragma once

#include "papers/exercises/course.h"

/// Predict. Two balls joined by a neck, lying on their side: minima, saddles, maxima of the height.
Counts dumbbell = unanswered;

/// Run. `caffeine.xyz`, the default height, before the simplification: how many saddles?
Count caffeine_saddles = unanswered;

/// Explain. At a critical point x = z + lambda M V. lambda^2 from w/2 and D = V . M V.
Formula<double(double half_weight, double D)> squared_lambda = unanswered;
