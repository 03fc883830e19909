#pragma once

#include <optional>
#include <string>
#include <vector>

#include "morse/morse_smale_complex.h"

namespace morskin::morse {

/// The first law that a Morse-Smale complex breaks, in words, or nothing: section 3.2's "each
/// region is surrounded by two saddle points, a minimum and a maximum", and what that stands on.
/// Linear time; for tests and for the app before it writes.
///
/// 1. Arcs come in fours, from one saddle to a minimum, a maximum, a minimum and a maximum. Each
///    saddle has four. Values rise from minimum to saddle to maximum.
/// 2. There are two regions for each saddle, and between any two neighbouring arcs of a saddle lies
///    a corner of exactly one of them.
/// 3. The arcs of an extremum form one circle about it, walked from region to region. (Not asked of
///    an extremum one of whose saddles has both pairs of arcs ending together: ids alone do not say
///    which of its sectors is whose.)
/// 4. Extrema without arcs are a minimum and a maximum for each sphere without saddles; with those
///    the arcs join everything into `components` parts.
/// 5. minima - saddles + maxima is 2 components - 2 genus with a genus of at least 0.
///
/// @param survives  by point, which ones the complex is of; empty for all. The others have no arcs.
std::optional<std::string> validate(const MorseSmaleComplex& complex,
                                    const std::vector<bool>& survives = {});

}  // namespace morskin::morse
