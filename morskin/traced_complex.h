#pragma once

/// Morse functions of a prepared skin, and the Morse-Smale complex of one.

#include <optional>

#include "geometry/run.h"
#include "morse/choose_function.h"
#include "morse/morse_smale_complex.h"
#include "morskin/prepared_skin.h"

namespace morskin {

/// @throws geometry::RefusedInput  for a direction or a point that is none
void require_usable(const morse::MorseFunction& function);

/// The function asked for, else the first default, that is a Morse function on the skin.
/// @param objection  a further reason against one
/// @throws morse::DegenerateFunction, geometry::RefusedInput
morse::ChosenFunction choose_function(const PreparedSkin& skin,
                                      const std::optional<morse::MorseFunction>& asked,
                                      const morse::Objection& objection = {});

struct TracedComplex {
  morse::MorseFunction function;
  morse::MorseSmaleComplex complex;
};

/// The same function's complex, which is complete and keeps its laws; so the default chosen may be
/// a later one. Stage: "integral lines".
/// @throws morse::DegenerateFunction, geometry::RefusedInput, geometry::Stopped
TracedComplex trace_complex(const PreparedSkin& skin,
                            const std::optional<morse::MorseFunction>& asked,
                            const geometry::Run& run = geometry::Run());

}  // namespace morskin
