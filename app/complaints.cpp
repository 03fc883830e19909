#include "app/complaints.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "app/nearest_option.h"
#include "app/output_names.h"

namespace morskin::app {
namespace {

/// What an option of the command that is used takes, as far as CLI11 converts it.
std::string kind_of_value(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : app.get_subcommands()) {
    const CLI::Option* option = command->get_option_no_throw(name);
    if (option == nullptr) continue;
    if (option->get_expected_max() == 0) return "no value";
    const std::string type = option->get_type_name();
    if (type.starts_with("INT") || type.starts_with("UINT")) return "a whole number";
  }
  return "a number";
}

/// Of "NAME: At Most 1 required but received N" and "NAME: 1 required TYPE missing", what is wrong;
/// any other text as it is.
std::string about_count(const std::string& text) {
  const std::string name = text.substr(0, text.find(": "));
  if (text.starts_with(name + ": At Most 1 required")) return name + " is given more than once";
  const bool lacks_value = text.starts_with(name + ": 1 required ") && text.ends_with(" missing");
  return lacks_value ? name + " wants a value" : text;
}

/// Of "NAME: Value VALUE not in range ...", where every range is one of whole numbers, whether the
/// value is one; any other text as about_count() has it.
std::string about_range(const std::string& text) {
  constexpr std::string_view given = ": Value ", digits = "0123456789";
  const std::size_t name_end = text.find(given), end = text.find(" not in range ");
  if (name_end == std::string::npos || end == std::string::npos) return about_count(text);
  const std::size_t begin = name_end + given.size();
  const std::string value = text.substr(begin, end - begin);
  const bool is_whole =
      value.find_first_not_of(digits, value.starts_with('-')) == std::string::npos;
  return is_whole ? text : text.substr(0, name_end) + " takes a whole number, not " + value;
}

/// Of "Could not convert: NAME = VALUE", what is wrong; any other text as about_range() has it.
std::string about_value(const CLI::App& app, const std::string& text) {
  constexpr std::string_view unread = "Could not convert: ", is = " = ";
  const std::size_t end = text.find(is);
  if (!text.starts_with(unread) || end == std::string::npos) return about_range(text);
  const std::string name = text.substr(unread.size(), end - unread.size());
  const std::string value = text.substr(end + is.size());
  const std::string kind = kind_of_value(app, name);
  const bool has_comma = kind == "a number" && value.find(',') != std::string::npos;
  return name + " takes " + kind + ", not " + value +
         (has_comma ? "; decimals follow a point" : "");
}

std::string unexpected(const std::vector<std::string>& words) {
  std::string text = words.size() == 1 ? "The following argument was not expected:"
                                       : "The following arguments were not expected:";
  for (const std::string& word : words) text += " " + word;
  return text;
}

}  // namespace

std::string complaint(const CLI::App& app, const CLI::Error& error) {
  const std::string said = error.what();
  const std::vector<std::string> left_over = app.remaining(true);
  const bool is_of_words = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  std::string text = is_of_words ? unexpected(left_over) : about_value(app, said);
  if (said.starts_with("--model: ")) {
    text += "; the model of a file that has several is --model-number";
  }
  for (const std::string& word : left_over) {
    const std::optional<std::string> option = nearest_option(app, word);
    if (option) text += "; " + word + " is no option, did you mean " + *option + "?";
    if (app.got_subcommand("info") && !word.starts_with('-') && names_a_mesh(word)) {
      text += "; to write it: morskin mesh INPUT -o " + word;
    }
  }
  return text;
}

}  // namespace morskin::app
