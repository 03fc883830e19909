#include "app/nearest_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <utility>
#include <vector>

namespace morskin::app {
namespace {

/// The fewest letters to put in, take out or change to make one word of the other.
/// Source: Levenshtein 1966.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);  // from the letters of a so far to each start of b
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, change});
    }
  }
  return row.back();
}

/// The command given; without one the program, which has options of its own.
std::vector<const CLI::App*> in_use(const CLI::App& app) {
  std::vector<const CLI::App*> given;
  for (const CLI::App* command : app.get_subcommands()) given.push_back(command);
  return given.empty() ? std::vector{&app} : given;
}

/// "-C" for "-c".
std::optional<std::string> with_other_case(const CLI::App& app, char letter) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  for (const CLI::App* command : in_use(app)) {
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_snames()) {
        if (lower(name[0]) == lower(letter) && name[0] != letter) return "-" + name;
      }
    }
  }
  return std::nullopt;
}

/// With their hyphens.
std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : in_use(app)) {
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  return names;
}

/// Whether the words of the part, between hyphens, stand in the whole.
bool has_words(std::string_view whole, std::string_view part) {
  const std::string words = std::string(part.substr(1)) + "-";
  return (std::string(whole) + "-").find(words) != std::string::npos;
}

/// "--probe" for "--probe-radius", "--biological-assembly" for "--assembly"; of several
/// the longest.
std::optional<std::string> of_same_words(const CLI::App& app, std::string_view word) {
  std::optional<std::string> longest;
  for (const std::string& name : long_names(app)) {
    if (!has_words(word, name) && !has_words(name, word)) continue;
    if (!longest || name.size() > longest->size()) longest = name;
  }
  return longest;
}

/// "--biological-assembly" for what others call it, with hyphens or without.
std::optional<std::string> of_same_meaning(const CLI::App& app, std::string word) {
  constexpr std::array<std::string_view, 4> others{"bioassembly", "biounit", "biologicalunit",
                                                   "biomolecule"};
  std::erase(word, '-');
  if (std::ranges::find(others, word) == others.end()) return std::nullopt;
  const std::vector<std::string> names = long_names(app);
  const auto own = std::ranges::find(names, "--biological-assembly");
  return own == names.end() ? std::nullopt : std::optional(*own);
}

}  // namespace

std::optional<std::string> nearest_option(const CLI::App& app, std::string_view typed) {
  std::string word(typed.substr(0, typed.find('=')));
  std::ranges::replace(word, '_', '-');  // as Python has it
  if (word.size() == 2 && word[0] == '-' && word[1] != '-') return with_other_case(app, word[1]);
  if (!word.starts_with("--") || word == "--") return std::nullopt;
  std::optional<std::string> nearest;
  std::size_t least = word.size() / 3;  // a third of the letters may be wrong
  for (const std::string& name : long_names(app)) {
    const bool is_start = word.size() > 3 && name.starts_with(word);
    const std::size_t distance = is_start ? 1 : edit_distance(word, name);
    if (distance > least || (nearest && distance == least)) continue;
    least = distance;
    nearest = name;
  }
  if (!nearest) nearest = of_same_meaning(app, word);
  return nearest ? nearest : of_same_words(app, word);
}

}  // namespace morskin::app
