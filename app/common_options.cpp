#include "app/common_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

namespace morskin::app {

void add_molecule_options(CLI::App& command, Typed& typed, const std::string& model) {
  command
      .add_option("--model", typed.skin.model,
                  "How radii become weights: paper, sas, vdw or ses-like; given for an\n"
                  "INPUT of weights, which XYZW has without it")
      ->check(CLI::IsMember({"paper", "sas", "vdw", "ses-like", "given"}))
      ->default_str(model);
  command.add_option("--probe", typed.skin.probe, "Probe radius, Angstrom; 0 for none")
      ->default_str("1.4");
  add_selection_options(command, typed.skin.selection);
}

void add_voids_option(CLI::App& command, Typed& typed, const std::string& voids) {
  command
      .add_option("--voids", typed.skin.voids,
                  "Voids inside the skin: keep; drop all, as if they were filled; or\n"
                  "drop those below a volume, cubic Angstrom. With a void go the bodies\n"
                  "inside it")
      ->default_str(voids);
}

void add_progress_option(CLI::App& command, Typed& typed) {
  command.add_option("--progress", typed.progress, "auto (on a terminal), always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

void add_limit_options(CLI::App& command, Limits& limits, Typed& typed) {
  command.add_option("--timeout", limits.timeout,
                     "Seconds after which to give up, with exit code 6");
  command.add_option("--max-memory", typed.max_memory,
                     "Bytes of memory at which to give up, with exit code 6; 2G is\n"
                     "2 GiB (default: what the machine has)");
}

void add_threads_option(CLI::App& command, unsigned& threads) {
  threads = std::max(1U, std::thread::hardware_concurrency());
  command
      .add_option("--threads", threads,
                  "Threads at most (all cores); two do most of the work, and\n"
                  "what is written is the same for any number")
      ->check(CLI::Range(1U, 1024U));
}

}  // namespace morskin::app
