#pragma once

#include "papers/exercises/course.h"

/// Predict. Two balls of weight 2 (patch radius 1): the distance, Angstrom, at which they just
/// touch.
Number touching_distance = unanswered;

/// Run. `1grm_model1.pdb`, gramicidin A: how many necks has its skin?
Count necks = unanswered;

/// Explain. The smaller of the two principal curvatures (without its sign) of a hyperboloid patch,
/// at a distance |u| from its centre, from w/2. The larger is 1/|u|.
Formula<double(double half_weight, double distance)> smaller_curvature = unanswered;
