#include <span>
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

void write_case(std::ostream& out, std::string_view pattern, const CommandEntry& command) {
  out << "    " << pattern << ")\n      options='" << all_names(command)
      << "'\n      case $previous in\n";
  for (const OptionEntry& option : command.options) write_case(out, option);
  out << "      esac ;;\n";
}

constexpr std::string_view beginning = R"(# bash completion for morskin. Made from its options.
_morskin() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  local options= values= files=
  # bash takes --model=sas for three words.
  if [[ $word == = ]]; then
    word=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  # It takes a:b for three too, and of these a completion is the last. Where something is quoted
  # there may be no break, and readline itself completes the names of files.
  local whole=${COMP_LINE:0:COMP_POINT} breaks=${COMP_WORDBREAKS//[^:=]} broken=
  if [[ $whole != *[\\\'\"\$\`~]* ]]; then
    whole=${whole##*[[:space:]]}
    [[ $whole == --*=* ]] && whole=${whole#*=}
    [[ $whole != -* ]] && broken=${whole%"${whole##*[$breaks]}"}
  fi
  case ${COMP_WORDS[1]} in
)";

constexpr std::string_view middle = R"(  esac
  if [[ -n $broken ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$whole")
    COMPREPLY=("${COMPREPLY[@]#"$broken"}")
    compopt -o filenames
  elif ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W ")";

constexpr std::string_view end = R"(" -- "$word"))
  elif [[ -n $values ]]; then
    compopt +o default
    COMPREPLY=($(compgen -W "$values" -- "$word"))
  elif [[ -z $files && $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  fi
}
complete -o default -F _morskin morskin
)";

}  // namespace

std::string bash_completion(const CommandEntry& program) {
  const std::span commands(program.commands);
  std::ostringstream out;
  out << beginning;
  for (const CommandEntry& command : commands.subspan(1)) write_case(out, command.name, command);
  write_case(out, "*", commands[0]);
  out << middle;
  for (const CommandEntry& command : commands) out << command.name << " ";
  out << all_names(program) << end;
  return out.str();
}

}  // namespace morskin::app
