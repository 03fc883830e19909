#pragma once

/// Morse functions as words: on the command line and in reports.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "app/arguments.h"
#include "morse/choose_function.h"

namespace morskin::app {

/// Parses "height:x,y,z" or "distance:x,y,z": the height along a direction of any length, or the
/// squared distance from a point, Angstrom.
/// @throws UsageError
morse::MorseFunction parsed_function(std::string_view text);

/// Parses the "x,y,z" after --height.
/// @throws UsageError
morse::MorseFunction parsed_height(std::string_view text);

/// Does a piece of work along a Morse function. Where that is degenerate, the exit code depends on
/// who chose it.
/// @param asked  for by the user, if any
/// @throws UsageError, morse::DegenerateFunction
template <class Work>
auto along_function(const std::optional<morse::MorseFunction>& asked, const Work& work) {
  try {
    return work();
  } catch (const morse::DegenerateFunction& error) {
    const std::string text = std::string(error.what()) + " with --function";
    if (asked) throw UsageError(text);
    throw morse::DegenerateFunction(text);
  }
}

/// "height along (0.02, 1, 0.01)" or "squared distance from (1, 2, 3)".
std::string in_words(const morse::MorseFunction& function);

/// {"kind": "height", "direction": [x, y, z]} or {"kind": "distance", "origin": [x, y, z]}.
nlohmann::ordered_json function_json(const morse::MorseFunction& function);

/// Of the function's values.
std::string_view unit_of(const morse::MorseFunction& function);

}  // namespace morskin::app
