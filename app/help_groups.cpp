#include "app/help_groups.h"

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace morskin::app {
namespace {

struct Group {
  const char* title;
  std::vector<std::string> options;
};

const std::array<Group, 5>& groups() {
  static const std::array<Group, 5> all{{
      {"The files", {"--output", "--surface", "--for", "--report", "--vertex-data"}},
      {"The atoms",
       {"--chain", "--waters", "--hetatm", "--altloc", "--hydrogens", "--model-number",
        "--biological-assembly"}},
      {"The skin", {"--model", "--probe", "--radii", "--voids"}},
      {"The triangles", {"-C", "--size", "--density", "--triangles", "--angle-goal"}},
      {"The run", {"--quiet", "--json", "--threads", "--timeout", "--max-memory"}},
  }};
  return all;
}

constexpr std::array<std::string_view, 19> laboratory{
    "--method",      "-Q",        "--function",    "--height",    "--grid",
    "--grow",        "--fronts",  "--guard",       "--snapshots", "--snapshot-at",
    "--decimals",    "--areas",   "--fail-fast",   "--progress",  "--snapshot-dir",
    "--certificate", "--grading", "--trace-tasks", "--order"};

/// Each option with its default behind what it does.
class Help : public CLI::Formatter {
 public:
  /// @param is_short  an option has one line: the first of its description, which is a whole
  explicit Help(bool is_short) : is_short_(is_short) {}

  /// One empty line between groups is enough.
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    return CLI::detail::find_and_replace(CLI::Formatter::make_help(app, name, mode), "\n\n\n",
                                         "\n\n");
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_type_size() == 0) return "";
    std::string type = option->get_type_name();
    if (is_short_) type = type.substr(0, type.find(':'));
    return " " + type + (option->get_required() ? " REQUIRED" : "");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = option->get_description();
    if (is_short_) text = text.substr(0, text.find('\n'));
    const std::string standard = option->get_default_str();
    return standard.empty() ? text : text + " [" + standard + "]";
  }

 private:
  bool is_short_;
};

}  // namespace

void show_defaults(CLI::App& app) { app.formatter(std::make_shared<Help>(false)); }

void group_options(CLI::App& mesh, bool shows_laboratory) {
  for (const Group& group : groups()) {
    for (const std::string& name : group.options) mesh.get_option(name)->group(group.title);
  }
  const char* const title = shows_laboratory ? "The laboratory" : "";  // none hides an option
  for (const std::string_view name : laboratory) mesh.get_option(std::string(name))->group(title);
  if (!shows_laboratory) mesh.formatter(std::make_shared<Help>(true));
}

}  // namespace morskin::app
