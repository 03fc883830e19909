#pragma once

/// What is written from the options themselves: manual pages, and what shells complete.

#include <map>
#include <string>

#include "app/manual/command_tree.h"

namespace morskin::app {

/// Pages in man(7)'s language by the names of their files: one of the program, one of each command.
std::map<std::string, std::string> man_pages(const CommandEntry& program);

/// For bash: commands, options, and values that are words; where a file is due, bash's own files.
/// @pre  the first command is the one for a file in the place of a command
std::string bash_completion(const CommandEntry& program);

/// The same for zsh, with descriptions.
std::string zsh_completion(const CommandEntry& program);

}  // namespace morskin::app
