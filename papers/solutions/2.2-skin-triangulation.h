#pragma once

#include "papers/exercises/course.h"

// Not 4. Edges are a share of rho, 2 R sqrt(1 - R^2) with R = CQ/(1 + 2CQ), which is a little less
// than proportional to C: 0.208 and 0.116. The square of their ratio is 3.2. Runs have 3.4 times as
// many, since for small C an even fan is kept below [U] and more vertices are put in afterwards.
Number times_as_many = 3.2;

// arcsin(1/1.73^2).
Number angle_bound_deg = 19.52;

// Let v be the centre of an empty ball through a, b, c, its radius at least C Q rho_abc, and y
// another vertex at a distance L. Then rho_abc <= L/(CQ), and since rho changes by at most the
// distance, rho_v <= rho_abc + L and rho_y <= rho_abc + 2L. So [L] holds for vy if 1/2 >
// (C/Q)(1/(CQ) + 2), that is Q^2 - 4CQ - 2 > 0. The root:
Formula<double(double C)> smallest_Q = [](double C) { return 2 * C + std::sqrt(4 * C * C + 2); };
