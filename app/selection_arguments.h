#pragma once

/// The options that choose the atoms of a molecule's file.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "skin/selection.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

/// The options as typed, before they are checked.
struct TypedSelection {
  std::optional<std::string> chains, locations, hydrogens, hetatms, model_number, assembly;
  bool waters = false;
};

/// Whether any of them was typed.
bool is_set(const TypedSelection& typed);

void add_selection_options(CLI::App& command, TypedSelection& typed);

/// @throws UsageError
skin::Selection parsed(const TypedSelection& typed);

/// Adds an object `selection` with what differs from the defaults, under the names of the options;
/// nothing if all are the defaults.
void add_selection(nlohmann::ordered_json& json, const skin::Selection& selection);

}  // namespace morskin::app
