#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <vector>

#include "app/manual/manual.h"
#include "app/version.h"

namespace morskin::app {
namespace {

constexpr std::size_t text_width = 72;

// A dash may be typed, inside a word too (--help-all), so none may become a hyphen; nor other signs
// ornaments.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// A line that begins like a request of roff's is none.
std::string shielded(const std::string& line) {
  return (line.starts_with('.') || line.starts_with('\'') ? "\\&" : "") + line;
}

std::string filled(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string result, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > text_width) {
      result += shielded(escaped(line)) + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? result : result + shielded(escaped(line)) + "\n";
}

std::vector<std::string> paragraphs(const std::string& text) {
  std::vector<std::string> result(1);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) {
      result.back() += line + "\n";
    } else if (!result.back().empty()) {
      result.emplace_back();
    }
  }
  return result;
}

std::string capitals(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

// Filled text; lines that begin with a blank stay lines.
std::string body(const std::string& paragraph) {
  std::istringstream lines(paragraph);
  std::string text, table;
  for (std::string line; std::getline(lines, line);) {
    (line.starts_with(' ') ? table : text) += line + "\n";
  }
  std::string result = filled(text);
  if (!table.empty()) {
    std::istringstream rows(table);
    result += (result.empty() ? "" : ".PP\n") + std::string(".nf\n");
    for (std::string row; std::getline(rows, row);) result += escaped(row) + "\n";
    result += ".fi\n";
  }
  return result;
}

// A paragraph under "Exit codes:" is a section of that name.
std::string footer(const std::string& text) {
  std::string result;
  for (const std::string& paragraph : paragraphs(text)) {
    const std::size_t end = paragraph.find('\n');
    const std::size_t colon = paragraph.find(':');
    if (end == std::string::npos) continue;
    if (colon + 1 == end) {
      const std::string rest = paragraph.substr(end + 1);
      result += ".SH " + capitals(paragraph.substr(0, colon)) + "\n" + body(rest);
    } else {
      result += (result.empty() ? ".SH NOTES\n" : ".PP\n") + body(paragraph);
    }
  }
  return result;
}

// In font B, bold, or I, italic.
std::string in_font(char font, std::string_view text) {
  std::string result = "\\f";
  result += font;
  result += escaped(text);
  return result += "\\fR";
}

std::string value_in_words(const OptionEntry& option) {
  std::string words;
  for (const std::string& choice : option.choices) words += (words.empty() ? "" : "|") + choice;
  return in_font('I', words.empty() ? option.value : words);
}

std::string entry(const OptionEntry& option) {
  const bool is_positional = !option.names[0].starts_with('-');
  std::string text = ".TP\n";
  for (const std::string& name : option.names) {
    if (&name != &option.names[0]) text += ", ";
    text += in_font(is_positional ? 'I' : 'B', name);
  }
  if (!option.value.empty() && !is_positional) text.append(" ").append(value_in_words(option));
  const bool is_sentence = option.description.ends_with('.');
  text.append("\n").append(filled(option.description + (is_sentence ? "" : ".")));
  if (option.is_required && !is_positional) text += "Required.\n";
  if (!option.default_value.empty()) text += filled("Default: " + option.default_value + ".");
  return text;
}

std::string options(const CommandEntry& command) {
  std::string result = ".SH OPTIONS\n";
  std::vector<std::string> groups;
  for (const OptionEntry& option : command.options) {
    if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
  }
  for (const std::string& group : groups) {
    if (groups.size() > 1) result += ".SS " + group + "\n";
    for (const OptionEntry& option : command.options) {
      if (option.group == group) result += entry(option);
    }
  }
  return result;
}

std::string head(const std::string& page, const std::string& summary) {
  std::ostringstream out;
  out << ".\\\" Made from the options of the command.\n.TH " << escaped(capitals(page)) << " 1 "
      << version_date << " \"morskin " << version << "\"\n.SH NAME\n"
      << filled(page + " - " + summary) << ".SH SYNOPSIS\n";
  return out.str();
}

std::string page_of(const CommandEntry& program, const CommandEntry& command) {
  std::string text = head(program.name + "-" + command.name, command.description);
  text += ".B " + program.name + " " + command.name + "\n";
  for (const OptionEntry& positional : command.positionals) {
    text += ".I " + positional.names[0] + (positional.is_list ? " ...\n" : "\n");
  }
  for (const OptionEntry& option : command.options) {
    if (option.is_required) {
      text += in_font('B', option.names[0]) + " " + value_in_words(option) + "\n";
    }
  }
  text += "[options]\n.SH ARGUMENTS\n";
  for (const OptionEntry& positional : command.positionals) text += entry(positional);
  return text + options(command) + footer(command.footer) + ".SH SEE ALSO\n.BR " + program.name +
         " (1)\n";
}

std::string page_of(const CommandEntry& program) {
  std::string text = head(program.name, "certified triangle meshes of molecular skin surfaces");
  text += ".B " + program.name + "\n.I COMMAND\n[options]\n.SH DESCRIPTION\n";
  bool is_first = true;
  for (const std::string& paragraph : paragraphs(program.description)) {
    text += (is_first ? "" : ".PP\n") + body(paragraph);
    is_first = false;
  }
  std::string see_also;
  text += ".SH COMMANDS\n";
  for (const CommandEntry& command : program.commands) {
    text += ".TP\n.B " + command.name + "\n" + filled(command.description + ".");
    see_also +=
        (see_also.empty() ? ".BR " : ",\n.BR ") + program.name + "\\-" + command.name + " (1)";
  }
  return text + options(program) + footer(program.footer) + ".SH SEE ALSO\n" + see_also + "\n";
}

}  // namespace

std::map<std::string, std::string> man_pages(const CommandEntry& program) {
  std::map<std::string, std::string> pages{{program.name + ".1", page_of(program)}};
  for (const CommandEntry& command : program.commands) {
    pages[program.name + "-" + command.name + ".1"] = page_of(program, command);
  }
  return pages;
}

}  // namespace morskin::app
