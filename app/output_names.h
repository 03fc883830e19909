#pragma once

/// Which names outputs may have.

#include <filesystem>
#include <string>

#include "app/arguments.h"

namespace morskin::app {

/// The ending of a path, with its dot, in small letters.
std::string lower_extension(const std::filesystem::path& path);

/// "-" and /dev/stdout.
bool is_standard_output(const std::filesystem::path& path);

/// Standard output, a device, a pipe: what takes bytes and keeps no name.
bool is_special(const std::filesystem::path& path);

/// @throw UsageError if the output has no name or is the molecule's own file.
void check_not_input(const std::filesystem::path& output, const MoleculeArguments& molecule);

/// @throw UsageError unless the outputs of `mesh`, its report included, are apart from the input
/// and from each other and from what the run names by itself, of known formats, and at most one
/// goes to standard output.
void check_outputs(const MeshArguments& mesh);

}  // namespace morskin::app
