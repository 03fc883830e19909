#pragma once

#include "papers/exercises/course.h"

/// Predict. `cube8.xyzr`, model paper, has 6 minima and all survive. With one front, how many
/// triangles lie on it when all bowls are laid and nothing has crept?
Count triangles_of_bowls = unanswered;

/// Run. `2buk.pdb.gz`, -C 0.2 --fronts 1: how many bowls are created?
Count bowls = unanswered;

/// Explain. On a sphere of radius rho a bowl is made with a disk of radius r, and its rim projected
/// along the gradient: how long is a rim edge?
Formula<double(double r, double rho)> rim_edge = unanswered;
