#include "app/manual/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

namespace morskin::app {
namespace {

// "TEXT:{keep,drop}" has two.
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close < open) return {};
  std::vector<std::string> choices;
  std::istringstream words(type.substr(open + 1, close - open - 1));
  for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  return choices;
}

std::string value_of(const CLI::Option& option, const std::string& type) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string kind = type.substr(0, type.find(':'));
  const bool is_number = kind == "FLOAT" || kind == "UINT" || kind == "INT";
  return is_number ? "NUMBER" : kind;
}

std::string in_one_paragraph(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

OptionEntry entry_of(const CLI::Option& option) {
  OptionEntry entry;
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (entry.names.empty()) entry.names.push_back(option.get_name());
  const std::string type = option.get_type_name();
  entry.value = value_of(option, type);
  entry.choices = choices_of(type);
  entry.description = in_one_paragraph(option.get_description());
  entry.default_value = option.get_default_str();
  entry.group = option.get_group();
  entry.is_required = option.get_required();
  entry.is_list = option.get_items_expected_max() > 1;
  return entry;
}

}  // namespace

CommandEntry command_tree(const CLI::App& app) {
  CommandEntry entry{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    auto& list = option->nonpositional() ? entry.options : entry.positionals;
    list.push_back(entry_of(*option));
  }
  for (const CLI::App* command : app.get_subcommands({})) {
    entry.commands.push_back(command_tree(*command));
  }
  return entry;
}

}  // namespace morskin::app
