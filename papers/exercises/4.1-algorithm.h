#pragma once

#include "papers/exercises/course.h"

/// Predict. The height on 5TMN's inhibitor has 5 minima, 12 saddles and 7 maxima. The second sweep
/// goes by the reversed function: how many minima, saddles and maxima has that?
Counts from_above = unanswered;

/// Run. `9dna.pdb`, as the command meshes it, with two fronts: how many bowls are created?
Count bowls_of_both = unanswered;

/// Explain. f is a height plus c times a squared distance, c >= 0, and g the length of its gradient
/// at x. How much larger than f(x) can f be within the distance d of x? A departure vertex goes on
/// only if that is still below the level where the two sweeps meet.
Formula<double(double g, double c, double d)> largest_rise = unanswered;
