#include "app/options.h"

#include <CLI/CLI.hpp>
#include <array>

#include "app/features_options.h"
#include "app/help_groups.h"
#include "app/help_text.h"
#include "app/shared_options.h"
#include "app/version.h"

namespace morskin::app {
namespace {

void add_snapshot_options(CLI::App& command, MeshArguments& mesh, Typed& typed) {
  command
      .add_option("--snapshots", mesh.snapshots,
                  "Write so many states of the growing mesh and its front, at even steps of\n"
                  "the Morse function, as snapshot-K.ply and .vtu (with --fronts 1)")
      ->check(CLI::Range(0, 100'000))
      ->default_str("0");
  command
      .add_option("--snapshot-at", typed.snapshots_at, "Also, or instead, at these values: v,v,...")
      ->type_name("FLOAT")
      ->default_str("none")
      ->allow_extra_args(false);
  command.add_option("--snapshot-dir", mesh.snapshot_folder, "The folder for them")
      ->type_name("FOLDER")
      ->default_str("here");
}

void add_mesh(CLI::App& app, MeshArguments& mesh, Typed& typed) {
  CLI::App& command = *app.add_subcommand("mesh", "Mesh a molecule's skin and certify the file");
  command.add_option("INPUT", mesh.molecule.input, "The molecule");
  add_surface_option(command, mesh.surface);
  command
      .add_option("-o,--output", mesh.outputs,
                  "The mesh by its ending: .ply .off .obj .stl .vtu .glb .npz .msh .vert.\n"
                  "Repeat it for several. .stl and .glb have single precision, the others are "
                  "exact; .vert writes\n"
                  ".face too. \"-\", /dev/null and the like take PLY")
      ->required()
      ->allow_extra_args(false);
  add_meshing_options(command, mesh, typed);
  command
      .add_option("--areas", mesh.areas,
                  "Also write the areas of atoms and residues to this file, as CSV")
      ->default_str("none");
  add_preset_option(command, typed);
  command.add_flag("--fail-fast", mesh.fail_fast,
                   "Of several models mesh none after one that fails");
  add_snapshot_options(command, mesh, typed);
  command.add_option("--report", mesh.report, "Also write the report to this file, as JSON")
      ->default_str("none");
  add_certificate_option(command, mesh.certificate);
  command
      .add_option("--trace-tasks", mesh.task_trace,
                  "Write what ran when to this file, in the JSON that browsers' tracing views\n"
                  "read; bench/replay.py tells from one of --threads 1 what more would bring")
      ->default_str("none");
  command.add_flag("--json", mesh.json, "Print the report as JSON");
  command.add_flag("-q,--quiet", mesh.quiet,
                   "Print nothing but errors, and the report if --json asks for it");
  add_threads_option(command, mesh.threads);
  add_limit_options(command, mesh.limits, typed);
  add_progress_option(command, typed);
  group_options(command, !typed.wants_short_help);
  const std::string more =
      "--help-all has more on each, and the rest: grading, methods, Q, fronts, Morse functions.\n";
  command.footer((typed.wants_short_help ? more : std::string()) +
                 "OUT gets its name once it has been read back and certified; else it is "
                 "OUT.unverified, exit code 5.");
}

void add_morse(CLI::App& app, MorseArguments& morse, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "morse", "Write the Morse-Smale complex of a height or distance on the skin");
  command.add_option("INPUT", morse.molecule.input, "The molecule")->required();
  command
      .add_option("-o,--output", morse.output,
                  ".json, everything, or .vtu, lines and points for ParaView;\n"
                  "\"-\", /dev/null and the like take JSON")
      ->required();
  add_molecule_options(command, typed);
  add_function_option(command, typed);
  command.add_flag("--raw", typed.is_raw, "Do not simplify");
  command.add_option("--persistence", typed.persistence,
                     "Cancel all pairs of at most this persistence, Angstrom for\n"
                     "a height, Angstrom^2 for a distance, and no others");
  command.add_flag("-q,--quiet", morse.quiet, "Print nothing but errors");
  add_progress_option(command, typed);
  command.footer(
      "By default arcs between overlapping protecting spheres are contracted, as in\n"
      "section 3.2 of the paper, where the persistence condition allows it.");
}

void add_balls(CLI::App& app, BallsArguments& balls, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "balls", "Write the balls really used, x y z r, r the radius of the atom's patch");
  command.add_option("INPUT", balls.molecule.input, "The molecule")->required();
  command.add_option("-o,--output", balls.output, "XYZR or XYZW file, or - for standard output")
      ->required();
  command.add_flag("--weights", balls.weights,
                   "Write XYZW, x y z w, w the weight: read again, it gives the very same skin");
  add_molecule_options(command, typed);
  command.add_flag("-q,--quiet", balls.quiet, "Print nothing but errors");
}

void add_info(CLI::App& app, InfoArguments& info, Typed& typed) {
  CLI::App& command =
      *app.add_subcommand("info", "Tell what a molecule file holds and how big its mesh will be");
  command.add_option("INPUT", info.molecule.input, "The molecule")->required();
  add_molecule_options(command, typed);
  add_voids_option(command, typed);
  add_sizing_options(command, typed);
  command.add_flag("--json", info.json, "Print JSON");
  add_threads_option(command, info.threads);
  add_progress_option(command, typed);
}

void add_check(CLI::App& app, CheckArguments& check, MoleculeArguments& against, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "check", "Check a mesh file: alone, or against the molecule whose skin it should be");
  command
      .add_option("MESH", check.mesh,
                  "PLY, OFF, OBJ, STL, VTU, MSH or MSMS (.vert or .face), of any tool, each\n"
                  "also gzipped; of curved triangles the corners and the nodes in edges")
      ->required();
  command.add_option("--against", against.input,
                     "The molecule; runs the whole certificate. Options below that are not\n"
                     "given are those that the mesh file states, if it does");
  add_surface_option(command, check.surface);
  add_certificate_option(command, check.certificate);
  add_molecule_options(command, typed);
  add_voids_option(command, typed);
  add_sizing_options(command, typed);
  // As a flag of a bool that it turns off its help would be called --no-self-intersections{false}.
  command.add_flag_callback(
      "--no-self-intersections", [&check] { check.self_intersections = false; },
      "Do not search for self-intersections");
  command.add_flag("--json", check.json, "Print all that was found as JSON");
  add_threads_option(command, check.threads);
  add_limit_options(command, check.limits, typed);
  add_progress_option(command, typed);
  command.footer(
      "Exit code 0: a closed oriented 2-manifold without degenerate, duplicate or intersecting\n"
      "triangles and, with --against, certified; 5: not, and the reason names the first element.");
}

void add_view(CLI::App& app, ViewArguments& view, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "view", "Write a page that shows the mesh and how it came to be, in any browser");
  command
      .add_option("INPUT", view.molecule.input,
                  "The molecule, which is meshed first; or a mesh: PLY, OFF, OBJ,\n"
                  "STL, VTU, MSH or MSMS, by its ending")
      ->required();
  command.add_option("-o,--output", view.output, "The page, .html; one file that needs no network")
      ->required();
  command.add_option("--against", view.against,
                     "The molecule whose skin the mesh is: then all layers but the sweep");
  command.add_option("--frames", view.growth,
                     "Meshes of a growing skin to play through beside, in order; a folder\n"
                     "stands for its snapshot-1.ply, snapshot-2.ply ...");
  add_molecule_options(command, typed);
  add_sizing_options(command, typed);
  add_size_goal_options(command, typed);
  add_function_option(command, typed);
  add_threads_option(command, view.threads);
  add_limit_options(command, view.limits, typed);
  command.add_flag("-q,--quiet", view.quiet, "Print nothing but errors");
  add_progress_option(command, typed);
  command.footer(
      "A molecule is meshed from one front, as in Algorithm 1, so that the page can run\n"
      "through the sweep again. A mesh that is not certified makes OUT.unverified, exit code 5.");
}

/// Says in help, manual and completions which values are files.
void name_files(CLI::App& app) {
  static constexpr std::array files{"INPUT",    "MESH",          "--output", "--areas",
                                    "--report", "--certificate", "--frames", "--against"};
  for (CLI::App* command : app.get_subcommands({})) {
    for (const char* name : files) {
      if (auto* option = command->get_option_no_throw(name)) option->type_name("FILE");
    }
  }
}

}  // namespace

void add_commands(CLI::App& app, AllArguments& all, Typed& typed) {
  app.description(about);
  app.footer(closing);
  app.require_subcommand(1);
  show_defaults(app);
  app.set_help_flag("-h,--help,--help-all", "Print this help and exit");
  app.set_version_flag("--version", "morskin " + std::string(version) + "\ncommit   " +
                                        std::string(commit) + "\ncompiler " +
                                        std::string(compiler));
  add_mesh(app, all.mesh, typed);
  add_features(app, all.features, typed);
  add_morse(app, all.morse, typed);
  add_balls(app, all.balls, typed);
  add_info(app, all.info, typed);
  add_check(app, all.check, all.against, typed);
  add_view(app, all.view, typed);
  add_render(app, all.render, typed.picture);
  add_limit_options(*app.get_subcommand("render"), all.render.limits, typed);
  add_figure(app, all.figure);
  add_batch(app, all.batch, typed);
  name_files(app);
}

}  // namespace morskin::app
