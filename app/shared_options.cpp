#include "app/shared_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>
#include <utility>

#include "app/presets.h"

namespace morskin::app {

void add_choice(CLI::App& command, const char* name, std::string& value,
                std::vector<std::string> words, const char* description) {
  command.add_option(name, value, description)
      ->check(CLI::IsMember(std::move(words)))
      ->capture_default_str();
}

void add_molecule_options(CLI::App& command, Typed& typed) {
  command
      .add_option("--model", typed.skin.model,
                  "How radii become balls: vdw, sas, ses-like or paper\n"
                  "(morskin --help has the formulas); given for an INPUT of weights, which\n"
                  "XYZW has without it")
      ->check(CLI::IsMember({"paper", "sas", "vdw", "ses-like", "given"}))
      ->default_str("vdw");
  command
      .add_option("--probe", typed.skin.probe,
                  "Radius of the solvent probe of sas and paper, Angstrom")
      ->default_str("1.4");
  command
      .add_option("--radii", typed.skin.radii,
                  "Radii: elements, bondi, alvarez, FILE, C=1.7,...\n"
                  "Here elements is Bondi 1964 and, where that has none, Mantina 2009 and\n"
                  "Alvarez 2013; bondi and alvarez are these alone. A FILE has an element or\n"
                  "RESIDUE:ATOM and a radius on each line, # begins a comment")
      ->default_str("elements or INPUT's");
  add_selection_options(command, typed.skin.selection);
}

void add_voids_option(CLI::App& command, Typed& typed) {
  command
      .add_option("--voids", typed.skin.voids,
                  "Voids: keep, drop, or the volume, A^3, below which to drop.\n"
                  "A void that is dropped is as if it were filled; with it go the bodies\n"
                  "inside it")
      ->default_str("keep");
}

void add_sizing_options(CLI::App& command, Typed& typed) {
  command
      .add_option("-C", typed.skin.C,
                  "Size over curvature radius; half makes 3 to 4 times as many.\n"
                  "Of a C above 0.25 half makes 5 to 11 times as many")
      ->default_str("0.08");
  command.add_option("-Q", typed.skin.Q, "Quality: every angle exceeds asin(1/Q^2)")
      ->default_str("1.65 or, with C above 0.107, just above the least that C allows");
  command
      .add_option("--size", typed.skin.size,
                  "Edges of about so many Angstrom where the skin is flat.\n"
                  "Elsewhere what -C allows, 0.4 unless it is given")
      ->default_str("no limit");
}

void add_size_goal_options(CLI::App& command, Typed& typed) {
  command
      .add_option("--density", typed.density,
                  "In place of --size: so many vertices per square Angstrom")
      ->default_str("as -C makes");
  command
      .add_option("--triangles", typed.triangles,
                  "In place of --size: about so many triangles in all")
      ->default_str("as -C makes");
}

void add_function_option(CLI::App& command, Typed& typed) {
  command
      .add_option("--function", typed.function,
                  "The Morse function: height:x,y,z or distance:x,y,z\n"
                  "along a direction; squared, from a point")
      ->default_str("height along y, tilted a little");
}

void add_progress_option(CLI::App& command, Typed& typed) {
  add_choice(command, "--progress", typed.progress, {"auto", "always", "never"},
             "Show it: auto (on a terminal), always or never");
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
      .add_option("--threads", threads, "Threads at most; the result is the same for any number")
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

void add_surface_option(CLI::App& command, std::optional<std::string>& surface) {
  command
      .add_option("--surface", surface,
                  "No molecule: sphere:R torus:R,r genus2 formula:... gaussian:...\n"
                  "Write formula:EXPRESSION[,within=W], where the expression in x y z is 0 and\n"
                  "|x|, |y|, |z| <= W; by default W is the least of 1, 2, 4, ... that holds\n"
                  "a closed surface with room. Or gaussian:MOLECULE[,decay=D][,level=L]")
      ->default_str("none");
}

namespace {

/// What the files hold beside triangles, and how.
void add_contents_options(CLI::App& command, MeshArguments& mesh, Typed& typed) {
  command
      .add_option("--vertex-data", typed.vertex_data,
                  "Into .ply .vtu .npz .msh .glb too: normal,curvature,... or all.\n"
                  "Choose from normal, curvature, directions, scale, atom, shares, component,\n"
                  "patch, residue, charge, separated by commas alone")
      ->default_str("none");
  command
      .add_option("--decimals", mesh.decimals,
                  "Write .vert and .face in columns, with so many decimals, 3 as MSMS does")
      ->default_str("all, so that no bit is lost")
      ->check(CLI::Range(1, 9));
  command
      .add_option("--order", mesh.order,
                  "2: curved triangles into .vtu and .msh\n"
                  "with a node on the skin in the middle of each edge; the certificate is of the\n"
                  "corners' mesh")
      ->check(CLI::Range(1, 2))
      ->default_str("1");
}

void add_method_options(CLI::App& command, MeshArguments& mesh, Typed& typed) {
  add_choice(command, "--method", typed.method,
             {"auto", "sweep", "static", "dynamic", "marching-cubes"},
             "How to mesh: sweep, Algorithm 1 of the paper; static, restricted\n"
             "Delaunay refinement, which makes fewer triangles; auto, the sweep, or\n"
             "static with C above 0.25, up to 50,000 balls, unless edges are asked for\n"
             "far shorter than their radii: it takes less time there; dynamic, growth\n"
             "from nothing; marching-cubes, for comparison: without quality, so as a\n"
             "rule not certified");
  command.add_option("--grid", mesh.grid_step, "Step of the grid of marching-cubes, Angstrom")
      ->default_str("for as many triangles as the sweep makes");
  command
      .add_option("--grow", typed.grow,
                  "T0..T1, of --method dynamic: stop when T1, Angstrom^2, has been added to\n"
                  "every weight; --snapshots are taken from T0 to T1. What is meshed and\n"
                  "certified is the skin at T1")
      ->default_str("-W..0, W the largest weight");
  command
      .add_option("--fronts", typed.fronts,
                  "Sweep so many subdomains, each for itself, a power of two; 1 sweeps from\n"
                  "below with one front, as the paper's Algorithm 1 does")
      ->default_str("as many as the size of the mesh is worth");
  add_choice(command, "--guard", typed.guard, {"everywhere", "adjacent", "spheres"},
             "Where the front looks for collisions: everywhere; adjacent or\n"
             "spheres are experiments that fail on most molecules");
}

}  // namespace

void add_preset_option(CLI::App& command, Typed& typed) {
  command
      .add_option("--for", typed.purpose,
                  "Set density, voids, data and format for: bem, learning.\n"
                  "Where no option does: bem, boundary elements; learning, points with all data")
      ->check(CLI::IsMember(preset_names()))
      ->default_str("none");
}

void add_meshing_options(CLI::App& command, MeshArguments& mesh, Typed& typed) {
  add_contents_options(command, mesh, typed);
  add_molecule_options(command, typed);
  add_voids_option(command, typed);
  add_sizing_options(command, typed);
  add_size_goal_options(command, typed);
  command
      .add_option("--grading", typed.grading,
                  "By how much edges may grow for each Angstrom, 0.2 for instance\n"
                  "from where they are short, with -C 0.4. By the static method")
      ->default_str("as -C allows, 0.18 with 0.08, 1.09 with 0.4");
  command
      .add_option("--angle-goal", typed.angle_goal,
                  "No angle below so many degrees.\n"
                  "Vertices are moved, taken out and put in for it; 0 for not at all. With 30 or "
                  "more no file\n"
                  "that has one below 30 is certified. From 35 on, up to C = 0.2, also none\n"
                  "above 105. With sweep and static")
      ->default_str("35 up to C = 0.2, 30 beyond");
  add_function_option(command, typed);
  command.add_option("--height", typed.height, "x,y,z: short for --function height:x,y,z")
      ->default_str("as --function");
  add_method_options(command, mesh, typed);
}

}  // namespace morskin::app
