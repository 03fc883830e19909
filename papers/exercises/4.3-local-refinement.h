#pragma once

#include "papers/exercises/course.h"

/// Predict. An insertion splits a triangle at a new vertex: how many triangles more?
Count triangles_of_an_insertion = unanswered;

/// Run. `9dna.pdb`, --fronts 1: how many insertions does the refinement make?
Count insertions = unanswered;

/// Explain. In a plane, should the edge between two triangles be flipped, given the angles opposite
/// it (radians)?
Formula<bool(double one, double other)> flip = unanswered;
