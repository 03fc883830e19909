#pragma once

#include "papers/exercises/course.h"

/// Predict. 6 saddles: how many regions has the complex?
Count regions_of_6_saddles = unanswered;

/// Run. `2buk.pdb.gz`, a protein of a virus, --raw: how many arcs are traced?
Count arcs_of_2buk = unanswered;

/// Explain. f(x) - f(p) for an extremum p and a point x of its patch, exactly, from d . d and
/// d . M d, where d = x - p, grad f = mu N(p), and c is 2 for a squared distance and 0 for a
/// height.
Formula<double(double c, double mu, double d_d, double d_Md)> rise = unanswered;
