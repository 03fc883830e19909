#include "app/shared_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

namespace morskin::app {

void add_molecule_options(CLI::App& command, Typed& typed) {
  command
      .add_option("--model", typed.skin.model,
                  "How radii become balls: vdw, sas, ses-like or paper\n"
                  "(morskin --help has the formulas); given for an INPUT of weights, which\n"
                  "XYZW has without it")
      ->check(CLI::IsMember({"paper", "sas", "vdw", "ses-like", "given"}))
      ->default_str("vdw");
  command.add_option("--probe", typed.skin.probe, "Radius of the solvent probe, Angstrom")
      ->default_str("1.4");
  command
      .add_option("--radii", typed.skin.radii,
                  "Radii: elements, bondi, alvarez, FILE, C=1.7,...\n"
                  "elements is Bondi 1964 and, where that has none, Mantina 2009 and Alvarez\n"
                  "2013; bondi and alvarez are these alone. A FILE has an element or\n"
                  "RESIDUE:ATOM and a radius on each line, # begins a comment")
      ->default_str("elements or INPUT's");
  add_selection_options(command, typed.skin.selection);
}

void add_voids_option(CLI::App& command, Typed& typed) {
  command
      .add_option("--voids", typed.skin.voids,
                  "Voids: keep, drop, or the volume, A^3, below which to drop\n"
                  "A void that is dropped is as if it were filled; with it go the bodies\n"
                  "inside it")
      ->default_str("keep");
}

void add_sizing_options(CLI::App& command, Typed& typed) {
  command
      .add_option("-C", typed.skin.C, "Size over the curvature radius; half makes 4 times as many")
      ->default_str("0.08");
  command.add_option("-Q", typed.skin.Q, "Quality: every angle exceeds asin(1/Q^2)")
      ->default_str("1.65 or, with C above 0.107, the least that C allows");
  command
      .add_option("--size", typed.skin.size,
                  "Edges of about so many Angstrom where the skin is flat\n"
                  "Elsewhere what -C allows, 0.4 unless it is given")
      ->default_str("no limit");
}

void add_function_option(CLI::App& command, Typed& typed) {
  command
      .add_option("--function", typed.function,
                  "The Morse function: height:x,y,z or distance:x,y,z\n"
                  "along a direction; squared, from a point")
      ->default_str("height along y, tilted a little");
}

void add_progress_option(CLI::App& command, Typed& typed) {
  command
      .add_option("--progress", typed.progress, "Show it: auto (on a terminal), always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

void add_limit_options(CLI::App& command, Limits& limits, Typed& typed) {
  command
      .add_option("--timeout", limits.timeout, "Seconds after which to give up, with exit code 6")
      ->default_str("no limit");
  command
      .add_option("--max-memory", typed.max_memory,
                  "Bytes at which to give up, with exit code 6, as in 2G")
      ->default_str("the machine's");
}

void add_threads_option(CLI::App& command, unsigned& threads) {
  threads = std::max(1U, std::thread::hardware_concurrency());
  command
      .add_option("--threads", threads,
                  "Threads at most; the mesh is the same for any number\n"
                  "Two do most of the work")
      ->default_str("all cores")
      ->check(CLI::Range(1U, 1024U));
}

void add_certificate_option(CLI::App& command, std::optional<std::filesystem::path>& certificate) {
  command
      .add_option("--certificate", certificate,
                  "Also write what certify/verify/verify.py needs to prove the mesh\n"
                  "anew, as JSON")
      ->default_str("none");
}

}  // namespace morskin::app
