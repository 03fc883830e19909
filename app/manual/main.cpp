// Writes the manual pages and the completions of bash and zsh into a folder: morskin_manual FOLDER.
// Part of the build.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/manual/manual.h"
#include "app/options.h"

int main(int count, char** words) {
  using namespace morskin::app;
  if (count != 2) {
    std::cerr << "morskin_manual FOLDER\n";
    return 2;
  }
  CLI::App app("", "morskin");
  AllArguments all;
  Typed typed;
  add_commands(app, all, typed);
  const CommandEntry program = command_tree(app);

  std::map<std::string, std::string> files = man_pages(program);
  files["morskin.bash"] = bash_completion(program);
  files["_morskin"] = zsh_completion(program);
  const std::filesystem::path folder = words[1];
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : files) {
    std::ofstream file(folder / name, std::ios::binary);
    if (!(file << text).flush()) {
      std::cerr << folder / name << ": cannot write\n";
      return 1;
    }
  }
}
