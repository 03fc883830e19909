#pragma once

/// What `mesh --for PURPOSE` sets where no option does. The figures behind it: papers/solvers.md.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/options.h"

namespace morskin::app {

std::vector<std::string> preset_names();
/// That of the format, with its point.
/// @pre one of preset_names()
const std::string& preset_ending(const std::string& name);

/// Fills in what was not typed, and gives outputs without an ending that of the preset's format.
/// A size of any kind takes the place of the preset's density; so does a method that takes none.
/// Notes in mesh.preset what was set.
/// @pre  typed.purpose is one of preset_names()
void apply_preset(Typed& typed, MeshArguments& mesh);

/// What was set, for the report.
nlohmann::ordered_json preset_json(const PresetUse& preset);
std::string preset_text(const PresetUse& preset);

}  // namespace morskin::app
