#pragma once

/// Options that several commands have. Each gives an option its names, its help text and the place
/// where its value goes, which must outlive the parser.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/options.h"

namespace morskin::app {

/// An option that takes one of these words. Its default is the value that there is.
void add_choice(CLI::App& command, const char* name, std::string& value,
                std::vector<std::string> words, const char* description);
/// --model, --probe, --radii and the options that choose atoms.
void add_molecule_options(CLI::App& command, Typed& typed);
void add_voids_option(CLI::App& command, Typed& typed);
/// -C, -Q and --size.
void add_sizing_options(CLI::App& command, Typed& typed);
/// --density and --triangles.
void add_size_goal_options(CLI::App& command, Typed& typed);
void add_function_option(CLI::App& command, Typed& typed);
/// A surface in place of a molecule's skin.
void add_surface_option(CLI::App& command, std::optional<std::string>& surface);
/// What of `mesh` makes the mesh what it is: all but files, reports, limits and snapshots.
void add_meshing_options(CLI::App& command, MeshArguments& mesh, Typed& typed);
/// --for.
void add_preset_option(CLI::App& command, Typed& typed);
void add_progress_option(CLI::App& command, Typed& typed);
/// --timeout and --max-memory.
void add_limit_options(CLI::App& command, Limits& limits, Typed& typed);
void add_threads_option(CLI::App& command, unsigned& threads);
void add_certificate_option(CLI::App& command, std::optional<std::filesystem::path>& certificate);

}  // namespace morskin::app
