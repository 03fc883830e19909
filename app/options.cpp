#include "app/options.h"

#include <CLI/CLI.hpp>

#include "app/common_options.h"
#include "app/features_options.h"
#include "app/help_groups.h"
#include "app/help_text.h"
#include "app/version.h"

namespace morskin::app {
namespace {

void add_sizing_options(CLI::App& command, Typed& typed) {
  command
      .add_option("-C", typed.skin.C,
                  "Size of the triangles over the curvature radius;\n"
                  "half of it makes four times as many")
      ->default_str("0.08");
  command.add_option("-Q", typed.skin.Q,
                     "Quality: every angle exceeds asin(1/Q^2) (default: 1.65 or,\n"
                     "with C above 0.107, the least that C allows)");
  command.add_option("--size", typed.skin.size,
                     "Edges of about this length, Angstrom, where the skin is flat enough;\n"
                     "elsewhere what -C allows, 0.4 unless it is given");
}

void add_function_option(CLI::App& command, Typed& typed) {
  command.add_option("--function", typed.function,
                     "The Morse function: height:x,y,z along a direction, or\n"
                     "distance:x,y,z, squared, from a point\n"
                     "(default: height along y, tilted a little)");
}

void add_certificate_option(CLI::App& command, std::optional<std::filesystem::path>& certificate) {
  command.add_option("--certificate", certificate,
                     "Also write what certify/verify/verify.py needs to prove the mesh\n"
                     "anew, as JSON");
}

void add_mesh(CLI::App& app, MeshArguments& mesh, Typed& typed) {
  CLI::App& command = *app.add_subcommand("mesh", "Mesh a molecule's skin and certify the file");
  command.add_option("INPUT", mesh.molecule.input, "The molecule")->required();
  command
      .add_option("-o,--output", mesh.outputs,
                  "The mesh, by its ending: .ply .off .obj .vtu .npz .msh .vert with .face\n"
                  "(exact), .stl .glb (single precision); repeat for several. \"-\",\n"
                  "/dev/null and the like take PLY")
      ->required()
      ->allow_extra_args(false);
  command.add_option("--vertex-data", typed.vertex_data,
                     "Into .ply .vtu .npz .msh .glb too: normal,curvature,directions,scale,\n"
                     "atom,shares,component,patch,residue,charge; or all");
  command
      .add_option("--decimals", mesh.decimals,
                  "Write .vert and .face in columns, with so many decimals, 3 as MSMS does\n"
                  "(default: all decimals, so that no bit is lost)")
      ->check(CLI::Range(1, 9));
  command
      .add_option("--order", mesh.order,
                  "2: curved triangles into .vtu and .msh, with a node on the skin in the\n"
                  "middle of each edge; the certificate is of the corners' mesh")
      ->check(CLI::Range(1, 2))
      ->default_str("1");
  command.add_option("--areas", mesh.areas,
                     "Also write the areas of atoms and residues to this file, as CSV");
  add_molecule_options(command, typed);
  add_voids_option(command, typed);
  add_sizing_options(command, typed);
  command.add_option("--density", typed.density,
                     "In place of --size: so many vertices per square Angstrom");
  command.add_option("--triangles", typed.triangles,
                     "In place of --size: so many triangles, found by trial meshes");
  command.add_option("--grading", typed.grading,
                     "By how much edges may grow for each Angstrom from where they are\n"
                     "short, 0.2 for instance, with -C 0.4; what -C allows anyway is 0.18\n"
                     "with 0.08 and 0.87 with 0.4. By the static method");
  command
      .add_option("--angle-goal", typed.angle_goal,
                  "Degrees: vertices are moved, taken out and put in until no angle is\n"
                  "smaller; 0 for not at all. With 30 or more no file that has one below\n"
                  "30 is certified. From 35 on, up to C = 0.2, also none above 105.\n"
                  "With sweep and static")
      ->default_str("35 up to C = 0.2, 30 beyond");
  add_function_option(command, typed);
  command.add_option("--height", typed.height, "x,y,z: short for --function height:x,y,z");
  command
      .add_option("--method", typed.method,
                  "How to mesh: sweep, Algorithm 1 of the paper; static, restricted\n"
                  "Delaunay refinement, which makes fewer triangles; auto, the sweep, or\n"
                  "static with C above 0.25 where no length limits most edges, up to 50,000\n"
                  "balls: it takes less time there; dynamic, growth from nothing;\n"
                  "marching-cubes, for comparison: without quality, so as a rule not\n"
                  "certified")
      ->check(CLI::IsMember({"auto", "sweep", "static", "dynamic", "marching-cubes"}))
      ->capture_default_str();
  command.add_option("--grid", mesh.grid_step,
                     "Step of the grid of marching-cubes, Angstrom (default: as many\n"
                     "triangles as the sweep makes)");
  command.add_option("--grow", typed.grow,
                     "T0..T1, of --method dynamic: stop when T1, Angstrom^2, has been added to\n"
                     "every weight; --snapshots are taken from T0 to T1 (default: -W..0, W the\n"
                     "largest weight). What is meshed and certified is the skin at T1");
  command.add_option("--fronts", typed.fronts,
                     "Sweep so many subdomains, each for itself, a power of two (default: as\n"
                     "many as the size of the mesh is worth); 1 sweeps from below with one\n"
                     "front, as the paper's Algorithm 1 does");
  command
      .add_option("--guard", typed.guard,
                  "Where the front looks for collisions: everywhere; adjacent or\n"
                  "spheres are experiments that fail on most molecules")
      ->check(CLI::IsMember({"everywhere", "adjacent", "spheres"}))
      ->capture_default_str();
  command.add_option("--snapshots", mesh.snapshots,
                     "Write so many states of the growing mesh and its front, at even steps of\n"
                     "the Morse function, as snapshot-K.ply and .vtu (with --fronts 1)");
  command
      .add_option("--snapshot-at", mesh.snapshot_values,
                  "Also, or instead, at these values: v,v,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--snapshot-dir", mesh.snapshot_folder, "The folder for them (default: here)");
  command.add_option("--report", mesh.report, "Also write the report to this file, as JSON");
  add_certificate_option(command, mesh.certificate);
  command.add_flag("--json", mesh.json, "Print the report as JSON");
  command.add_flag("-q,--quiet", mesh.quiet,
                   "Print nothing but errors, and the report if --json asks for it");
  add_threads_option(command, mesh.threads);
  add_limit_options(command, mesh.limits, typed);
  add_progress_option(command, typed);
  group_options(command, !typed.wants_short_help);
  command.footer(
      "--help-all also lists the laboratory: methods, Q, fronts, snapshots, Morse functions.\n"
      "\n"
      "The mesh takes its name only when the bytes written have been read back and certified:\n"
      "homeomorphic to the skin, [L] and [U] met everywhere. Otherwise it is left as\n"
      "OUT.unverified, the exit code is 5, and an older OUT stays as it was.");
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
}

void add_check(CLI::App& app, CheckArguments& check, MoleculeArguments& against, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "check", "Check a mesh file: alone, or against the molecule whose skin it should be");
  command
      .add_option("MESH", check.mesh,
                  "PLY, OFF, OBJ, STL, VTU, MSH or MSMS (.vert or .face), of any tool, each\n"
                  "also gzipped; of curved triangles the corners")
      ->required();
  command.add_option("--against", against.input,
                     "The molecule; runs the whole certificate. Options below that are not\n"
                     "given are those that the mesh file states, if it does");
  add_certificate_option(command, check.certificate);
  add_molecule_options(command, typed);
  add_voids_option(command, typed);
  add_sizing_options(command, typed);
  command.add_flag("!--no-self-intersections", check.self_intersections,
                   "Do not search for self-intersections");
  command.add_flag("--json", check.json, "Print all that was found as JSON");
  add_threads_option(command, check.threads);
  add_limit_options(command, check.limits, typed);
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
                  "STL or MSMS, by its ending")
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
  add_function_option(command, typed);
  add_threads_option(command, view.threads);
  add_limit_options(command, view.limits, typed);
  command.add_flag("-q,--quiet", view.quiet, "Print nothing but errors");
  add_progress_option(command, typed);
  command.footer(
      "A molecule is meshed from one front, as in Algorithm 1, so that the page can run\n"
      "through the sweep again. A mesh that is not certified makes OUT.unverified, exit code 5.");
}

}  // namespace

void add_commands(CLI::App& app, AllArguments& all, Typed& typed) {
  app.description(about);
  app.footer(closing);
  app.require_subcommand(1);
  app.set_version_flag("--version", "morskin " + std::string(version));
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
}

}  // namespace morskin::app
