#pragma once

#include <optional>
#include <span>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

/// The command that words without one mean: `mesh` where there is an output, else `info` for a
/// molecule and `check` for a mesh. Behind "--" stands no output and no command, but inputs.
/// @param words  of the command line, without the program's name
/// @param app    with all commands
/// @return nothing where the first word is a command, or where the words ask for none
/// @throws UsageError  the first word is neither "--" nor a command nor a file
std::optional<std::string> implied_command(std::span<const char* const> words, const CLI::App& app);

}  // namespace morskin::app
