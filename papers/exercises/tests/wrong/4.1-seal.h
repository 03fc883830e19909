#pragma once

#include "papers/exercises/course.h"

// Answers as a student might give them.
Count triangles_of_7_edges = 6;
Count seals = unanswered;
Formula<double(double C, double Q)> largest_hole = [](double C, double Q) { return C * Q; };
