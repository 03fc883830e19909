#pragma once

#include "morse/simplification.h"

namespace morskin::ablation {

/// Contracts arcs as section 3.2 prints it: any between overlapping protecting spheres, the
/// shortest first, whichever extremum is the lower and whatever other saddles it has (errata E11).
/// Only an arc whose saddle leads to no other extremum stays. Spheres that still overlap shrink
/// (E10), for which nothing is printed.
/// @pre validate(complex) finds nothing
morse::Simplification contract_by_distance(const morse::MorseSmaleComplex& complex,
                                           double radius_share);

}  // namespace morskin::ablation
