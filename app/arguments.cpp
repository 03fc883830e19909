#include "app/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>

#include "app/complex_files.h"
#include "app/function_argument.h"
#include "app/limits.h"
#include "app/version.h"
#include "geometry/mesh_files.h"
#include "geometry/text_lines.h"

namespace morskin::app {
namespace {

constexpr double largest_probe = 1e4;  // Angstrom; keeps the weights in the predicates' range

constexpr const char* about =
    "morskin writes a triangle mesh of a molecule's skin surface that is proved homeomorphic to "
    "the\n"
    "surface, has no angle below 21 degrees, and can be checked again from the written file.\n"
    "\n"
    "INPUT is PDB, mmCIF, PQR, XYZ or XYZR, each also gzipped; \"-\" is standard input. Lengths "
    "are\n"
    "in Angstrom, angles in degrees. The first model is read, of alternate places the likeliest,\n"
    "and no water unless asked.\n";

constexpr const char* closing =
    "Models (r: the atom's van der Waals radius, p: the probe's, W: weight of the ball; the\n"
    "atom's sphere patch has the radius sqrt(W/2)):\n"
    "  paper   W = sqrt(2) (r + p), as the paper prints it (default)\n"
    "  sas     W = 2 (r + p)^2      patches have the solvent-accessible radius\n"
    "  vdw     W = 2 r^2            patches have the radius r; the probe plays no part\n"
    "\n"
    "Examples:\n"
    "  morskin mesh 1crn.pdb -o 1crn.ply\n"
    "  morskin mesh 1crn.cif.gz -o 1crn.ply -o 1crn.vtu --model vdw --report 1crn.json\n"
    "  morskin check 1crn.ply --against 1crn.pdb\n"
    "  morskin morse 1crn.pdb -o 1crn.json --function distance:9,9,7\n"
    "  morskin info 1crn.pdb --json\n"
    "  morskin view 1crn.pdb -o 1crn.html\n"
    "\n"
    "Exit codes:\n"
    "  0  meshed and certified           5  not certified: see OUT.unverified\n"
    "  2  wrong arguments                6  a limit of memory or time was reached\n"
    "  3  input unreadable               7  output not writable\n"
    "  4  input refused (names atoms)   70  internal error\n";

// The options as typed, before they are checked.
struct Typed {
  std::string model = "paper";
  std::optional<std::string> height, function;
  std::optional<double> persistence;
  bool is_raw = false;
  std::string progress = "auto";
  std::string method = "sweep";
  std::string max_memory;
  std::string guard = "everywhere";
  std::optional<int> fronts;
  std::optional<double> C, Q, size;
  std::optional<std::string> grow;
};

void add_molecule_options(CLI::App& command, MoleculeArguments& molecule, Typed& typed) {
  command.add_option("--model", typed.model, "How radii become weights: paper, sas or vdw")
      ->check(CLI::IsMember({"paper", "sas", "vdw"}))
      ->capture_default_str();
  command.add_option("--probe", molecule.probe, "Probe radius, Angstrom; 0 for none")
      ->capture_default_str();
  command.add_flag("--waters", molecule.waters, "Keep the waters");
}

void add_sizing_options(CLI::App& command, Typed& typed) {
  command
      .add_option("-C", typed.C,
                  "Size of the triangles over the curvature radius;\n"
                  "half of it makes four times as many")
      ->default_str("0.08");
  command.add_option("-Q", typed.Q,
                     "Quality: every angle exceeds asin(1/Q^2) (default: 1.65 or,\n"
                     "with C above 0.109, the least that C allows)");
  command.add_option("--size", typed.size,
                     "Edges of about this length, Angstrom, where the skin is flat enough;\n"
                     "elsewhere, and in place of a longer one, what -C gives, then 0.2\n"
                     "unless it is given");
}

void add_function_option(CLI::App& command, Typed& typed) {
  command.add_option("--function", typed.function,
                     "The Morse function: height:x,y,z along a direction, or\n"
                     "distance:x,y,z, squared, from a point\n"
                     "(default: height along y, tilted a little)");
}

void add_progress_option(CLI::App& command, Typed& typed) {
  command.add_option("--progress", typed.progress, "auto (on a terminal), always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

void add_threads_option(CLI::App& command, unsigned& threads) {
  threads = std::max(1U, std::thread::hardware_concurrency());
  command
      .add_option("--threads", threads,
                  "Threads at most (all cores); two do most of the work, and\n"
                  "what is written is the same for any number")
      ->check(CLI::Range(1U, 1024U));
}

void add_mesh(CLI::App& app, MeshArguments& mesh, Typed& typed) {
  CLI::App& command = *app.add_subcommand("mesh", "Mesh a molecule's skin and certify the file");
  command.add_option("INPUT", mesh.molecule.input, "The molecule")->required();
  command
      .add_option("-o,--output", mesh.outputs,
                  "The mesh, by its ending: .ply, .off, .obj, .vtu (exact)\n"
                  "or .stl (single precision); repeat for several.\n"
                  "\"-\", /dev/null and the like take PLY")
      ->required()
      ->allow_extra_args(false);
  add_molecule_options(command, mesh.molecule, typed);
  add_sizing_options(command, typed);
  command
      .add_option("--angle-goal", mesh.angle_goal_deg,
                  "Degrees: vertices are moved along the skin until no angle is smaller,\n"
                  "as far as -C and -Q allow it; 0 for not at all")
      ->capture_default_str();
  add_function_option(command, typed);
  command.add_option("--height", typed.height, "x,y,z: short for --function height:x,y,z");
  command
      .add_option("--method", typed.method,
                  "How to mesh: sweep, Algorithm 1 of the paper; static, restricted\n"
                  "Delaunay refinement; dynamic, growth from nothing; marching-cubes,\n"
                  "for comparison: without quality, so as a rule not certified")
      ->check(CLI::IsMember({"sweep", "static", "dynamic", "marching-cubes"}))
      ->capture_default_str();
  command.add_option("--grid", mesh.grid_step,
                     "Step of the grid of marching-cubes, Angstrom (default: as many\n"
                     "triangles as the sweep makes)");
  command.add_option("--grow", typed.grow,
                     "T0..T1, of --method dynamic: stop when T1, Angstrom^2, has been added to\n"
                     "every weight; --snapshots are taken from T0 to T1 (default: -W..0, W the\n"
                     "largest weight). What is meshed and certified is the skin at T1");
  command
      .add_option("--fronts", typed.fronts,
                  "2 sweeps from below and from above at once; 1 from below only,\n"
                  "Algorithm 1 as the paper prints it")
      ->check(CLI::IsMember({1, 2}))
      ->default_str("2");
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
  command.add_flag("--json", mesh.json, "Print the report as JSON");
  command.add_flag("-q,--quiet", mesh.quiet, "Print nothing but errors");
  add_threads_option(command, mesh.threads);
  command.add_option("--timeout", mesh.timeout, "Seconds after which to give up, with exit code 6");
  command.add_option("--max-memory", typed.max_memory,
                     "Bytes of memory at which to give up, with exit code 6; 2G is\n"
                     "2 GiB (default: what the machine has)");
  add_progress_option(command, typed);
  command.footer(
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
  add_molecule_options(command, morse.molecule, typed);
  add_function_option(command, typed);
  command.add_flag("--raw", typed.is_raw, "Do not simplify");
  command.add_option("--persistence", typed.persistence,
                     "Cancel all pairs of at most this persistence, Angstrom for\n"
                     "a height, Angstrom^2 for a distance, and no others");
  command.add_flag("-q,--quiet", morse.quiet, "Print nothing but errors");
  add_progress_option(command, typed);
  command.footer(
      "Unless told otherwise, arcs between overlapping protecting spheres are contracted, as in\n"
      "section 3.2 of the paper, where the persistence condition allows it.");
}

void add_balls(CLI::App& app, BallsArguments& balls, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "balls", "Write the balls really used, x y z r, r the radius of the atom's patch");
  command.add_option("INPUT", balls.molecule.input, "The molecule")->required();
  command.add_option("-o,--output", balls.output, "XYZR file, or - for standard output")
      ->required();
  add_molecule_options(command, balls.molecule, typed);
  command.add_flag("-q,--quiet", balls.quiet, "Print nothing but errors");
}

void add_info(CLI::App& app, InfoArguments& info, Typed& typed) {
  CLI::App& command =
      *app.add_subcommand("info", "Tell what a molecule file holds and how big its mesh will be");
  command.add_option("INPUT", info.molecule.input, "The molecule")->required();
  add_molecule_options(command, info.molecule, typed);
  add_sizing_options(command, typed);
  command.add_flag("--json", info.json, "Print JSON");
}

void add_check(CLI::App& app, CheckArguments& check, MoleculeArguments& against, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "check", "Check a mesh file: alone, or against the molecule whose skin it should be");
  command
      .add_option("MESH", check.mesh,
                  "PLY, OFF, OBJ, STL or MSMS (.vert or .face), of any tool, each also gzipped")
      ->required();
  command.add_option("--against", against.input, "The molecule; runs the whole certificate");
  add_molecule_options(command, against, typed);
  add_sizing_options(command, typed);
  command.add_flag("!--no-self-intersections", check.self_intersections,
                   "Do not search for self-intersections");
  command.add_flag("--json", check.json, "Print all that was found as JSON");
  add_threads_option(command, check.threads);
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
  add_molecule_options(command, view.molecule, typed);
  add_sizing_options(command, typed);
  add_function_option(command, typed);
  add_threads_option(command, view.threads);
  command.add_flag("-q,--quiet", view.quiet, "Print nothing but errors");
  add_progress_option(command, typed);
  command.footer(
      "A molecule is meshed from one front, as Algorithm 1 is printed, so that the page can run\n"
      "through the sweep again. A mesh that is not certified makes OUT.unverified, exit code 5.");
}

// --height and --function, of which at most one may be given.
std::optional<morse::MorseFunction> parsed(const Typed& typed) {
  if (typed.height && typed.function) {
    throw UsageError("--height x,y,z is short for --function height:x,y,z; give one of them");
  }
  if (typed.height) return parsed_height(*typed.height);
  if (typed.function) return parsed_function(*typed.function);
  return std::nullopt;
}

// "1500000", "200K", "1.5G": K, M, G and T stand for powers of 1024.
std::uint64_t parsed_bytes(std::string_view text) {
  constexpr std::string_view units = "KMGT";
  constexpr double most = 0x1p62;  // far beyond any machine, far from overflow
  std::string_view digits = text;
  double factor = 1;
  if (!text.empty()) {
    const std::size_t unit = units.find(static_cast<char>(text.back() & ~0x20));
    if (unit != std::string_view::npos) {
      factor = std::ldexp(1.0, 10 * static_cast<int>(unit + 1));
      digits.remove_suffix(1);
    }
  }
  const std::optional<double> value = geometry::parse_double(digits);
  if (!value || !(*value * factor >= 1 && *value * factor <= most)) {
    throw UsageError("--max-memory needs a number of bytes, or one with K, M, G or T, as in 2G");
  }
  return static_cast<std::uint64_t>(*value * factor);
}

void check_sizing(const refine::Sizing& sizing) {
  if (!(sizing.C > 0) || !std::isfinite(sizing.C)) throw UsageError("-C must be above 0");
  if (!(sizing.Q > 1) || !std::isfinite(sizing.Q)) throw UsageError("-Q must be above 1");
  if (!(2 * sizing.C < sizing.Q)) throw UsageError("-C must be below half of -Q");
}

void set_edge_length(refine::Sizing& sizing, double length) {
  if (!(length > 0) || !std::isfinite(length)) throw UsageError("--size must be above 0 Angstrom");
  sizing.set_edge_length(length);
}

void finish(MoleculeArguments& molecule, const Typed& typed) {
  molecule.model = *skin::parse_model(typed.model);
  if (!(molecule.probe >= 0 && molecule.probe <= largest_probe)) {
    throw UsageError("--probe must be from 0 to 10000 Angstrom");
  }
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_standard_output(const std::filesystem::path& path) {
  return path == "-" || path == "/dev/stdout";
}

bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  return is_standard_output(path) || (std::filesystem::exists(path, ignored) &&
                                      !std::filesystem::is_regular_file(path, ignored));
}

// The one name of a file, whatever way its path is written.
std::filesystem::path one_name(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::path name = std::filesystem::weakly_canonical(path, failed);
  return failed ? std::filesystem::absolute(path).lexically_normal() : name;
}

void check_not_input(const std::filesystem::path& output, const MoleculeArguments& molecule) {
  if (output.empty()) throw UsageError("an output's name is empty");
  if (!is_special(output) && one_name(output) == one_name(molecule.input)) {
    throw UsageError(output.string() + " would replace the input; choose another name");
  }
}

void check_outputs(const MeshArguments& mesh) {
  std::vector<std::filesystem::path> names = mesh.outputs;
  if (mesh.report) names.push_back(*mesh.report);
  std::size_t standard_outputs = mesh.json ? 1 : 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    check_not_input(names[i], mesh.molecule);
    if (is_standard_output(names[i])) ++standard_outputs;
    if (is_special(names[i])) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (one_name(names[i]) == one_name(names[j])) {
        throw UsageError(names[i].string() + " is named twice");
      }
    }
  }
  if (standard_outputs > 1) throw UsageError("only one thing can go to standard output");
  for (const std::filesystem::path& output : mesh.outputs) {
    if (!is_special(output) && !geometry::mesh_format_of(output)) {
      throw UsageError(output.string() +
                       ": the ending stands for no mesh format; use .ply, .off, .obj, .stl or "
                       ".vtu");
    }
  }
}

ShowProgress parsed_progress(std::string_view word) {
  if (word == "always") return ShowProgress::Always;
  return word == "never" ? ShowProgress::Never : ShowProgress::Auto;
}

void finish(MorseArguments& morse, const Typed& typed) {
  check_not_input(morse.output, morse.molecule);
  if (!is_special(morse.output) && !complex_format_of(morse.output)) {
    throw UsageError(morse.output.string() + ": the ending must be .json or .vtu");
  }
  morse.function = parsed(typed);
  morse.progress = parsed_progress(typed.progress);
  if (typed.is_raw && typed.persistence) {
    throw UsageError("--raw does not simplify and --persistence does; give one of them");
  }
  if (typed.is_raw) morse.simplify = Simplify::Not;
  if (typed.persistence) {
    if (!(*typed.persistence >= 0)) throw UsageError("--persistence must not be below 0");
    morse.simplify = Simplify::ByPersistence;
    morse.persistence = *typed.persistence;
  }
}

void finish(ViewArguments& view, const Typed& typed) {
  check_not_input(view.output, view.molecule);
  if (view.against && !names_a_mesh(view.molecule.input)) {
    throw UsageError("--against is for a mesh; a molecule is shown with its own skin");
  }
  if (view.against) check_not_input(view.output, {.input = *view.against});
  for (const std::filesystem::path& frame : view.growth) {
    check_not_input(view.output, {.input = frame});
  }
  if (!is_special(view.output) && lower_extension(view.output) != ".html") {
    throw UsageError(view.output.string() + ": the ending must be .html");
  }
  view.function = parsed(typed);
  view.progress = parsed_progress(typed.progress);
}

/// --grow T0..T1
void parse_growth(MeshArguments& mesh, const std::string& text) {
  if (mesh.method != front::Method::Dynamic) throw UsageError("--grow is for --method dynamic");
  double from = 0, to = 0;
  // "-3..0" would read "-3." as a number: cut at the two dots.
  const std::size_t dots = text.find("..");
  if (dots != std::string::npos) {
    std::istringstream first(text.substr(0, dots)), last(text.substr(dots + 2));
    if (first >> from && first.eof() && last >> to && last.eof() && std::isfinite(from) &&
        std::isfinite(to) && from < to) {
      mesh.growth_shown_from = from;
      mesh.grow_to = to;
      return;
    }
  }
  throw UsageError("--grow needs two times, the earlier first, as in --grow -3..0");
}

void finish(MeshArguments& mesh, const Typed& typed) {
  mesh.function = parsed(typed);
  mesh.progress = parsed_progress(typed.progress);
  mesh.method = *front::parse_method(typed.method);
  if (!(mesh.angle_goal_deg >= 0 && mesh.angle_goal_deg <= 60)) {
    throw UsageError("--angle-goal must be from 0 to 60");
  }
  if (mesh.grid_step && mesh.method != front::Method::MarchingCubes) {
    throw UsageError("--grid is for --method marching-cubes");
  }
  if (mesh.grid_step && !(*mesh.grid_step > 0 && std::isfinite(*mesh.grid_step))) {
    throw UsageError("--grid must be above 0");
  }
  if (typed.grow) parse_growth(mesh, *typed.grow);
  if (typed.guard == "adjacent") mesh.guard = front::Guard::Adjacent;
  if (typed.guard == "spheres") mesh.guard = front::Guard::Spheres;
  const bool has_snapshots = mesh.snapshots > 0 || !mesh.snapshot_values.empty();
  const bool is_dynamic = mesh.method == front::Method::Dynamic;
  mesh.fronts = typed.fronts.value_or(has_snapshots && !is_dynamic ? 1 : 2);
  if (has_snapshots && !is_dynamic && mesh.fronts != 1) {
    throw UsageError("snapshots are of a sweep from below only: leave out --fronts 2");
  }
  for (const double value : mesh.snapshot_values) {
    if (!std::isfinite(value)) throw UsageError("--snapshot-at needs finite numbers");
  }
  if (typed.size && mesh.method != front::Method::Sweep && mesh.method != front::Method::Static) {
    throw UsageError("--size is for the methods sweep and static");
  }
  check_outputs(mesh);
}

}  // namespace

bool names_a_mesh(const std::filesystem::path& path) {
  std::string ending = lower_extension(path);
  if (ending == ".gz") ending = lower_extension(path.stem());
  constexpr std::array<std::string_view, 6> endings{".ply", ".off",  ".obj",
                                                    ".stl", ".vert", ".face"};
  return std::ranges::find(endings, ending) != endings.end();
}

Arguments parse_arguments(int count, const char* const* words) {
  CLI::App app(about, "morskin");
  app.footer(closing);
  app.require_subcommand(1);
  app.set_version_flag("--version", "morskin " + std::string(version));
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "morskin: " + std::string(error.what()) + "; see morskin --help\n";
  });
  MeshArguments mesh;
  MorseArguments morse;
  BallsArguments balls;
  InfoArguments info;
  CheckArguments check;
  ViewArguments view;
  MoleculeArguments against;
  Typed typed;
  add_mesh(app, mesh, typed);
  add_morse(app, morse, typed);
  add_balls(app, balls, typed);
  add_info(app, info, typed);
  add_check(app, check, against, typed);
  add_view(app, view, typed);
  RenderArguments render;
  TypedPicture typed_picture;
  add_render(app, render, typed_picture);
  FigureArguments figure;
  add_figure(app, figure);
  try {
    app.parse(count, words);
    for (MoleculeArguments* molecule : {&mesh.molecule, &morse.molecule, &balls.molecule,
                                        &info.molecule, &against, &view.molecule}) {
      finish(*molecule, typed);
    }
    for (refine::Sizing* sizing : {&mesh.sizing, &info.sizing, &check.sizing, &view.sizing}) {
      sizing->C = typed.C.value_or(typed.size ? refine::Sizing::largest_proved_C : sizing->C);
      sizing->Q = typed.Q.value_or(refine::Sizing::quality_for(sizing->C));
      check_sizing(*sizing);
      if (typed.size) set_edge_length(*sizing, *typed.size);
    }
    if (app.got_subcommand("balls")) return balls;
    if (app.got_subcommand("info")) return info;
    if (app.got_subcommand("render")) {
      finish(render, typed_picture);
      return render;
    }
    if (app.got_subcommand("figure")) {
      finish(figure);
      return figure;
    }
    if (app.got_subcommand("check")) {
      if (!against.input.empty()) check.against = against;
      return check;
    }
    if (app.got_subcommand("view")) {
      finish(view, typed);
      return view;
    }
    if (app.got_subcommand("morse")) {
      finish(morse, typed);
      return morse;
    }
    if (mesh.timeout && !(*mesh.timeout > 0 && *mesh.timeout <= TimeLimit::most_seconds)) {
      throw UsageError("--timeout must be above 0 and at most 1e8 seconds");
    }
    if (!typed.max_memory.empty()) mesh.max_memory = parsed_bytes(typed.max_memory);
    finish(mesh, typed);
    return mesh;
  } catch (const CLI::ParseError& error) {
    const bool is_complaint = error.get_exit_code() != 0;
    app.exit(error, std::cout, std::cerr);
    return Finished{is_complaint ? ExitCode::Usage : ExitCode::Success};
  } catch (const UsageError& error) {
    std::cerr << "morskin: " << error.what() << "; see morskin --help\n";
    return Finished{ExitCode::Usage};
  }
}

}  // namespace morskin::app
