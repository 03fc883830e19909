#pragma once

#include "papers/exercises/course.h"

// Every triangle takes one edge off, and the last one three.
Count triangles_of_7_edges = 5;

// Fewer than the 274 maxima that survive: the others are reached by a front that closes by itself.
Count seals = 155;

// [U] asks for R < C Q rho. All vertices of the hole on one circle of that radius.
Formula<double(double C, double Q)> largest_hole = [](double C, double Q) { return 2 * C * Q; };
