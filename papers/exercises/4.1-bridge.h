#pragma once

#include "papers/exercises/course.h"

/// Predict. A ring of twelve balls (`ring12.xyzr`, model vdw, --fronts 1) has one minimum, two
/// saddles and one maximum that survive. How many bridges are built?
Count ring_bridges = unanswered;

/// Run. `2buk.pdb.gz`, -C 0.18 --fronts 1: how many touches does the guard find outside of
/// protecting spheres?
Count touches_outside = unanswered;

/// Explain. How far below a saddle at a waist are the two branches of a level set as close as an
/// edge is long? To leading order; rho is the length scale there.
Formula<double(double rho, double edge)> depth_of_gap = unanswered;
