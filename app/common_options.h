#pragma once

/// The options that several commands share.

#include <filesystem>
#include <optional>
#include <string>

#include "app/options.h"

namespace morskin::app {

/// @param model, voids  the defaults that the help states
void add_molecule_options(CLI::App& command, Typed& typed, const std::string& model = "vdw");
void add_voids_option(CLI::App& command, Typed& typed, const std::string& voids = "keep");
void add_progress_option(CLI::App& command, Typed& typed);
void add_limit_options(CLI::App& command, Limits& limits, Typed& typed);
void add_threads_option(CLI::App& command, unsigned& threads);

}  // namespace morskin::app
