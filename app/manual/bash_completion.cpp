#include <sstream>
#include <string_view>

#include "app/manual/manual.h"

namespace morskin::app {
namespace {

std::string joined(const std::vector<std::string>& words, char between) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

std::string all_names(const CommandEntry& command) {
  std::vector<std::string> names;
  for (const OptionEntry& option : command.options) names.push_back(joined(option.names, ' '));
  return joined(names, ' ');
}

// What may follow an option: words, nothing that is known, or files.
void write_case(std::ostream& out, const OptionEntry& option) {
  if (option.value.empty()) return;
  out << "        " << joined(option.names, '|') << ") ";
  if (!option.choices.empty()) {
    out << "values='" << joined(option.choices, ' ') << "'";
  } else {
    out << (option.value == "NUMBER" ? "values=' '" : "files=1");
  }
  out << " ;;\n";
}

void write_case(std::ostream& out, const CommandEntry& command) {
  out << "    " << command.name << ")\n      options='" << all_names(command)
      << "'\n      case $previous in\n";
  for (const OptionEntry& option : command.options) write_case(out, option);
  out << "      esac ;;\n";
}

constexpr std::string_view beginning = R"(# bash completion for morskin. Made from its options.
_morskin() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  local command= options= values= files=
  # bash takes --model=sas for three words.
  if [[ $word == = ]]; then
    word=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  # A file in the place of the command is meshed.
  if ((COMP_CWORD > 1)); then command=mesh; fi
  case ${COMP_WORDS[1]} in
)";

constexpr std::string_view middle = R"(  esac
  case $command in
)";

constexpr std::string_view end = R"(  esac
  if [[ -n $values ]]; then
    compopt +o default
    COMPREPLY=($(compgen -W "$values" -- "$word"))
  elif [[ -z $files ]]; then
    if [[ $word == -* || -z $command ]]; then
      COMPREPLY=($(compgen -W "$options" -- "$word"))
    fi
  fi
}
complete -o default -F _morskin morskin
)";

}  // namespace

std::string bash_completion(const CommandEntry& program) {
  std::vector<std::string> names;
  for (const CommandEntry& command : program.commands) names.push_back(command.name);
  std::ostringstream out;
  out << beginning << "    " << joined(names, '|') << ") command=${COMP_WORDS[1]} ;;\n" << middle;
  for (const CommandEntry& command : program.commands) write_case(out, command);
  out << "    *) options='" << joined(names, ' ') << " " << all_names(program) << "' ;;\n" << end;
  return out.str();
}

}  // namespace morskin::app
