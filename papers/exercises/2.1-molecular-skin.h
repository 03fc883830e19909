#pragma once

#include "papers/exercises/course.h"

/// Predict. Two balls of weight 2 (patch radius 1): the distance, Angstrom, at which they just
/// touch.
Number touching_distance = unanswered;

/// Run. `cube8.xyzr`, model paper: components of the skin, and its Euler characteristic.
Count cube_components = unanswered;
Count cube_euler_characteristic = unanswered;

/// Explain. The smaller of the two principal curvatures (without its sign) of a hyperboloid patch,
/// at a distance |u| from its centre, from w/2. The larger is 1/|u|.
Formula<double(double half_weight, double distance)> smaller_curvature = unanswered;
