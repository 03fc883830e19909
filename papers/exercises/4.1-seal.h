#pragma once

#include "papers/exercises/course.h"

/// Predict. How many triangles close a hole of 7 edges without a new vertex?
Count triangles_of_7_edges = unanswered;

/// Run. `2buk.pdb.gz`, -C 0.18 --fronts 1: how many maxima are sealed?
Count seals = unanswered;

/// Explain. How large may a hole's diameter be, over rho, so that a triangle with that diameter for
/// its circumdisk keeps [U]?
Formula<double(double C, double Q)> largest_hole = unanswered;
