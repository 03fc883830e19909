#pragma once

#include <optional>
#include <string>
#include <vector>

#include "morse/morse_smale_complex.h"

namespace morskin::morse {

/// The first law that a Morse-Smale complex breaks, in words, or nothing: section 3.2's "each
/// region is surrounded by two saddle points, a minimum and a maximum", and its premises. Takes the
/// time of sorting the regions; for tests and for the app before it writes.
///
/// 1. Arcs come in fours, from one saddle to a minimum, a maximum, a minimum and a maximum. Each
///    saddle has four. Values rise from minimum to saddle to maximum.
/// 2. Each arc is once in `ends`, in cyclic order about its extremum. Minima and maxima order their
///    arcs so that the quadrangles between them are the same.
/// 3. The regions are these quadrangles, two for each saddle.
/// 4. Extrema without arcs are a minimum and a maximum for each sphere without saddles; with those
///    the arcs join everything into `components` parts, and so do the descending arcs alone, and
///    the ascending ones.
/// 5. minima - saddles + maxima is 2 components - 2 genus with a genus of at least 0.
///
/// @param survives  by point, whether it belongs to the complex; empty for all. Others have no
/// arcs.
std::optional<std::string> validate(const MorseSmaleComplex& complex,
                                    const std::vector<bool>& survives = {});

}  // namespace morskin::morse
