#include "app/help_groups.h"

#include <CLI/CLI.hpp>
#include <array>
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
      {"The files", {"--output", "--vertex-data", "--order", "--areas", "--report"}},
      {"The atoms",
       {"--model-number", "--chain", "--waters", "--hetatm", "--altloc", "--hydrogens"}},
      {"The skin", {"--model", "--probe", "--voids"}},
      {"The triangles", {"-C", "--size", "--density", "--triangles", "--grading", "--angle-goal"}},
      {"The run", {"--json", "--quiet", "--threads", "--timeout", "--max-memory", "--progress"}},
  }};
  return all;
}

constexpr std::array<std::string_view, 13> laboratory{
    "--method",  "-Q",      "--function",  "--height",      "--grid",         "--grow",
    "--fronts",  "--guard", "--snapshots", "--snapshot-at", "--snapshot-dir", "--certificate",
    "--decimals"};

}  // namespace

void group_options(CLI::App& mesh, bool shows_laboratory) {
  for (const Group& group : groups()) {
    for (const std::string& name : group.options) mesh.get_option(name)->group(group.title);
  }
  const char* const title = shows_laboratory ? "The laboratory" : "";  // none hides an option
  for (const std::string_view name : laboratory) mesh.get_option(std::string(name))->group(title);
}

}  // namespace morskin::app
