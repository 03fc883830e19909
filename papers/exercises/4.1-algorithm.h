#pragma once

#include "papers/exercises/course.h"

/// Predict. The height on 5TMN's inhibitor has 5 minima, 12 saddles and 7 maxima. How many
/// has the reversed function?
Counts of_reversed = unanswered;

/// Run. `2buk.pdb.gz`, -C 0.2, as the command meshes it, in subdomains: how many bowls are created?
Count bowls_of_subdomains = unanswered;

/// Explain. Space is halved d times: each half of the first time is halved the second time, and so
/// on. How many sweeps are there in all, those of the strips between boxes included?
Formula<double(double d)> sweeps = unanswered;
