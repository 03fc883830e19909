#pragma once

/// The parser's commands and options as plain values, for manual pages and completions.

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

struct OptionEntry {
  std::vector<std::string> names;  ///< with their dashes; of a positional its one name
  std::string value;  ///< what follows it: FILE, FOLDER, NUMBER, TEXT; empty for a flag
  std::vector<std::string> choices;  ///< all values there are, if they are words
  std::string description;           ///< one paragraph, without breaks
  std::string default_value;
  std::string group;  ///< the title of its group in the help
  bool is_required;
  bool is_list;  ///< takes several values
};

struct CommandEntry {
  std::string name;
  std::string description, footer;  ///< as typed, in lines
  std::vector<OptionEntry> positionals, options;
  std::vector<CommandEntry> commands;
};

/// All of it, the options that only --help-all lists as well.
CommandEntry command_tree(const CLI::App& app);

}  // namespace morskin::app
