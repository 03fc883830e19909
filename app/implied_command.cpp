#include "app/implied_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <string_view>

#include "app/arguments.h"
#include "skin/molecule_files.h"

namespace morskin::app {
namespace {

/// "-o", "-oOUT", "--output", "--output=OUT".
bool gives_output(std::string_view word) {
  return word.starts_with("-o") || word == "--output" || word.starts_with("--output=");
}

bool is_end_of_options(std::string_view word) { return word == "--"; }

bool is_command(const CLI::App& app, const std::string& word) {
  return std::ranges::any_of(app.get_subcommands({}),
                             [&](const CLI::App* command) { return command->get_name() == word; });
}

std::string listed_commands(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return names;
}

}  // namespace

std::optional<std::string> implied_command(std::span<const char* const> words,
                                           const CLI::App& app) {
  if (words.empty()) return std::nullopt;
  // What stands behind "--" is an input, whatever it looks like.
  const auto end_of_options = std::ranges::find_if(words, is_end_of_options);
  const bool is_input = end_of_options == words.begin() && words.size() > 1;
  const std::string first = words[is_input ? 1 : 0];
  if (!is_input && is_command(app, first)) return std::nullopt;
  const bool has_output = std::any_of(words.begin(), end_of_options, gives_output);
  const bool is_option = !is_input && first.starts_with("-") && first != "-";
  if (is_option) return has_output ? std::optional<std::string>("mesh") : std::nullopt;
  std::error_code ignored;
  const bool is_file = is_input || first == "-" || names_a_mesh(first) ||
                       skin::molecule_format_of(first) || std::filesystem::exists(first, ignored);
  if (!is_file) {
    throw UsageError("'" + first + "' is neither a command nor a file; commands are " +
                     listed_commands(app));
  }
  if (has_output) return "mesh";
  return names_a_mesh(first) ? "check" : "info";
}

}  // namespace morskin::app
