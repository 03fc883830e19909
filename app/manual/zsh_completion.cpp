#include <span>
#include <sstream>
#include <string_view>

#include "app/manual/manual.h"

namespace morskin::app {
namespace {

// For single quotes within _arguments' own language.
std::string quoted(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result;
}

void write_action(std::ostream& out, const OptionEntry& option) {
  if (option.choices.empty()) {
    out << (option.value == "NUMBER" ? " " : option.value == "FOLDER" ? "_files -/" : "_files");
    return;
  }
  char before = '(';
  for (const std::string& choice : option.choices) {
    out << before << choice;
    before = ' ';
  }
  out << ")";
}

// '(-o --output)'{-o+,--output=}'[description]:FILE:_files'; a list may be given again.
void write_option(std::ostream& out, const OptionEntry& option) {
  std::string names, forms;
  for (const std::string& name : option.names) {
    names.append(names.empty() ? "" : " ").append(name);
    forms.append(forms.empty() ? "" : ",").append(name);
    if (!option.value.empty()) forms += name.starts_with("--") ? '=' : '+';
  }
  if (option.names.size() > 1) forms = "{" + forms + "}";
  out << " \\\n            '" << (option.is_list ? "*" : "(" + names + ")") << "'" << forms << "'["
      << quoted(option.description) << "]";
  if (!option.value.empty()) {
    out << ":" << option.value << ":";
    write_action(out, option);
  }
  out << "'";
}

void write_case(std::ostream& out, std::string_view pattern, const CommandEntry& command) {
  out << "        " << pattern << ")\n          _arguments";
  for (const OptionEntry& option : command.options) write_option(out, option);
  for (const OptionEntry& positional : command.positionals) {
    out << " \\\n            '" << (positional.is_list ? "*:" : ":") << positional.names[0]
        << ":_files'";
  }
  out << " ;;\n";
}

}  // namespace

std::string zsh_completion(const CommandEntry& program) {
  std::ostringstream out;
  out << "#compdef morskin\n# Made from the options of the command.\n_morskin() {\n"
         "  local state\n  _arguments -C";
  for (const OptionEntry& option : program.options) write_option(out, option);
  out << " \\\n    '1: :->command' '*:: :->arguments'\n  case $state in\n    command)\n"
         "      local -a commands=(\n";
  for (const CommandEntry& command : program.commands) {
    out << "        '" << command.name << ":" << quoted(command.description) << "'\n";
  }
  out << "      )\n      _describe command commands\n      _files ;;\n    arguments)\n"
         "      case $words[1] in\n";
  const std::span commands(program.commands);
  for (const CommandEntry& command : commands.subspan(1)) write_case(out, command.name, command);
  write_case(out, "*", commands[0]);
  out << "      esac ;;\n  esac\n}\n_morskin \"$@\"\n";
  return out.str();
}

}  // namespace morskin::app
