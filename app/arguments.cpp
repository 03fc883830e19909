#include "app/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cmath>
#include <iostream>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "app/complex_files.h"
#include "app/features_options.h"
#include "app/function_argument.h"
#include "app/implied_command.h"
#include "app/limits.h"
#include "app/nearest_option.h"
#include "app/options.h"
#include "app/output_names.h"
#include "app/presets.h"
#include "app/typed_values.h"
#include "front/subdomains.h"
#include "skin/molecule_files.h"

namespace morskin::app {
namespace {

// --height and --function, of which at most one may be given.
std::optional<morse::MorseFunction> parsed(const Typed& typed) {
  if (typed.height && typed.function) {
    throw UsageError("--height x,y,z is short for --function height:x,y,z; give one of them");
  }
  if (typed.height) return parsed_height(*typed.height);
  if (typed.function) return parsed_function(*typed.function);
  return std::nullopt;
}

void finish(morskin::SizeGoal& goal, const Typed& typed) {
  if (typed.skin.size.has_value() + typed.density.has_value() + typed.triangles.has_value() > 1) {
    throw UsageError("--size, --density and --triangles are three ways to say one thing");
  }
  if (typed.density && !(*typed.density > 0 && std::isfinite(*typed.density))) {
    throw UsageError("--density must be above 0");
  }
  constexpr double max_triangles = geometry::SurfaceMesh::max_triangles;
  if (typed.triangles && !(*typed.triangles >= 4 && *typed.triangles <= max_triangles)) {
    throw UsageError("--triangles must be at least 4");
  }
  goal.density = typed.density;
  goal.triangles = typed.triangles;
}

void finish(Limits& limits, const Typed& typed) {
  if (limits.timeout && !(*limits.timeout > 0 && *limits.timeout <= Limits::max_timeout)) {
    throw UsageError("--timeout must be above 0 and at most 1e8 seconds");
  }
  if (!typed.max_memory.empty()) limits.max_memory = parsed_bytes(typed.max_memory);
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

/// The ending must not say that the fourth numbers are what they are not.
void finish(BallsArguments& balls, const Typed&) {
  const auto format = skin::molecule_format_of(balls.output);
  if (balls.weights && format == skin::MoleculeFormat::Xyzr) {
    throw UsageError(balls.output.string() + ": with --weights the ending must be .xyzw");
  }
  if (!balls.weights && format == skin::MoleculeFormat::Xyzw) {
    throw UsageError(balls.output.string() + ": only --weights writes .xyzw");
  }
}

void finish(ViewArguments& view, const Typed& typed) {
  check_not_input(view.output, view.molecule);
  if (view.against && !names_a_mesh(view.molecule.input)) {
    throw UsageError("--against is for a mesh; a molecule is shown with its own skin");
  }
  const bool is_mesh_alone = !view.against && names_a_mesh(view.molecule.input);
  if (is_mesh_alone && (is_set(typed.skin) || parsed(typed))) {
    throw UsageError("the options of a skin are of a mesh and its molecule: add --against");
  }
  if (view.against) check_not_input(view.output, {.input = *view.against});
  for (const std::filesystem::path& frame : view.growth) {
    check_not_input(view.output, {.input = frame});
  }
  if (!is_special(view.output) && lower_extension(view.output) != ".html") {
    throw UsageError(view.output.string() + ": the ending must be .html");
  }
  finish(view.size_goal, typed);
  if (view.size_goal.is_set() && names_a_mesh(view.molecule.input)) {
    throw UsageError("--density and --triangles are for a molecule, which is meshed first");
  }
  view.typed = typed.skin;
  view.function = parsed(typed);
  view.progress = parsed_progress(typed.progress);
}

void check_grading(const MeshArguments& mesh) {
  if (!(*mesh.grading >= morskin::min_grading && std::isfinite(*mesh.grading))) {
    throw UsageError("--grading must be at least 0.01");
  }
  if (mesh.method != MeshMethod::Auto && mesh.method != MeshMethod::Static) {
    throw UsageError("--grading is for --method static");
  }
  if (mesh.angle_goal_deg.value_or(certify::guaranteed_angle_deg) < certify::guaranteed_angle_deg) {
    throw UsageError("--grading needs an --angle-goal of 30 or more");
  }
}

/// Each of several models needs files of its own.
void check_several(const MeshArguments& mesh) {
  const auto refuse = [](const std::string& what) {
    throw UsageError("several models cannot " + what + "; choose one with --model-number");
  };
  if (mesh.molecule.input == "-" || mesh.molecule.radii == "-") refuse("come from standard input");
  if (std::ranges::any_of(mesh.outputs, is_standard_output)) refuse("go to standard output");
  for (const auto& path : {mesh.report, mesh.certificate, mesh.areas, mesh.task_trace}) {
    if (path && is_standard_output(*path)) refuse("go to standard output");
  }
  if (mesh.has_snapshots()) refuse("all have snapshots");
}

/// What only a molecule's skin has, with the option that asks for it.
void check_surface(const MeshArguments& mesh, const Typed& typed) {
  if (!mesh.molecule.input.empty()) {
    throw UsageError("a molecule and --surface are two surfaces; give one of them");
  }
  const TypedSkin& skin = typed.skin;
  const bool is_of_skins = skin.model || skin.probe || skin.radii || mesh.models || skin.voids ||
                           is_set(skin.selection) || typed.vertex_data || mesh.areas ||
                           mesh.certificate || mesh.task_trace || mesh.order == 2;
  if (is_of_skins) {
    throw UsageError(
        "--surface goes without the options of molecules, --vertex-data, --areas, --order 2, "
        "--certificate and --trace-tasks");
  }
  const bool is_sweep = mesh.method == MeshMethod::Auto || mesh.method == MeshMethod::Sweep;
  if (!is_sweep || mesh.guard != front::Guard::Everywhere || mesh.size_goal.is_set() ||
      mesh.grading || (mesh.function && !mesh.function->is_height())) {
    throw UsageError("--surface goes with --method sweep, along a height, and with --size only");
  }
  if (std::ranges::any_of(mesh.outputs, [](const auto& path) { return is_msms(path); })) {
    throw UsageError("MSMS's files are of molecules; write --surface to another format");
  }
}

void finish(MeshArguments& mesh, const Typed& typed) {
  if (mesh.molecule.input.empty() && !mesh.surface) {
    throw UsageError("INPUT is missing: a molecule, or --surface");
  }
  mesh.typed = typed.skin;
  if (mesh.models) check_several(mesh);
  if (mesh.fail_fast && !mesh.models) {
    throw UsageError("--fail-fast is for several models, as in --model-number all");
  }
  mesh.function = parsed(typed);
  mesh.progress = parsed_progress(typed.progress);
  mesh.method = *parse_method(typed.method);
  const bool is_of_a_sweep = typed.fronts || typed.guard != "everywhere" || mesh.has_snapshots();
  if (mesh.method == MeshMethod::Auto && is_of_a_sweep) mesh.method = MeshMethod::Sweep;
  const bool is_sweep = mesh.method == MeshMethod::Sweep;
  const bool is_dynamic = mesh.method == MeshMethod::Dynamic;
  const bool is_smoothed = !is_dynamic && mesh.method != MeshMethod::MarchingCubes;
  if (typed.angle_goal && !is_smoothed) {
    throw UsageError("--angle-goal is for the methods sweep and static");
  }
  mesh.angle_goal_deg = is_smoothed ? typed.angle_goal : 0;
  if (mesh.angle_goal_deg && !(*mesh.angle_goal_deg >= 0 && *mesh.angle_goal_deg <= 60)) {
    throw UsageError("--angle-goal must be from 0 to 60");
  }
  if (mesh.grid_step && mesh.method != MeshMethod::MarchingCubes) {
    throw UsageError("--grid is for --method marching-cubes");
  }
  if (mesh.grid_step && !(*mesh.grid_step > 0 && std::isfinite(*mesh.grid_step))) {
    throw UsageError("--grid must be above 0");
  }
  if (typed.grow) {
    if (!is_dynamic) throw UsageError("--grow is for --method dynamic");
    std::tie(mesh.growth_shown_from, mesh.grow_to) = parsed_growth(*typed.grow);
  }
  if ((typed.fronts || typed.guard != "everywhere") && !is_sweep) {
    throw UsageError("--fronts and --guard are for --method sweep");
  }
  if (typed.guard == "adjacent") mesh.guard = front::Guard::Adjacent;
  if (typed.guard == "spheres") mesh.guard = front::Guard::Spheres;
  if (mesh.has_snapshots() && !is_sweep && !is_dynamic) {
    throw UsageError("snapshots are for the methods sweep and dynamic");
  }
  if (typed.fronts && !(*typed.fronts >= 1 && *typed.fronts <= front::max_subdomains)) {
    throw UsageError("--fronts must be 1 to " + std::to_string(front::max_subdomains));
  }
  if (typed.fronts && !std::has_single_bit(*typed.fronts)) {
    throw UsageError("--fronts must be a power of two, as boxes are halved");
  }
  mesh.fronts = typed.fronts;
  if (mesh.has_snapshots() && is_sweep && mesh.fronts.value_or(1) != 1) {
    throw UsageError("snapshots are of one front from below: leave out --fronts");
  }
  if (mesh.has_snapshots() && is_sweep) mesh.fronts = 1;
  for (const double value : mesh.snapshot_values) {
    if (!std::isfinite(value)) throw UsageError("--snapshot-at needs finite numbers");
  }
  finish(mesh.size_goal, typed);
  if ((typed.skin.size || mesh.size_goal.is_set()) && !is_smoothed) {
    throw UsageError("--size, --density and --triangles are for the methods sweep and static");
  }
  mesh.grading = typed.grading;
  if (mesh.grading) check_grading(mesh);
  if (typed.vertex_data) mesh.vertex_data = parsed_vertex_data(*typed.vertex_data);
  add_msms_partners(mesh.outputs);
  check_outputs(mesh);
  if (typed.vertex_data && std::ranges::none_of(mesh.outputs, takes_vertex_data)) {
    throw UsageError("--vertex-data goes into .ply, .vtu, .glb, .npz and .msh; none is written");
  }
  if (mesh.order == 2 && std::ranges::none_of(mesh.outputs, takes_second_order)) {
    throw UsageError("--order 2 is of .vtu and .msh files, and none is written");
  }
  if (mesh.surface) check_surface(mesh, typed);
  if (mesh.decimals &&
      std::ranges::none_of(mesh.outputs, [](const auto& path) { return is_msms(path); })) {
    throw UsageError("--decimals is of .vert and .face files, and none is written");
  }
}

void finish(FeaturesArguments& features, const Typed& typed) {
  finish(features.mesh, typed);
  finish_features(features);
}

void finish(const CheckArguments& check, const Typed& typed) {
  if (check.surface && check.against) {
    throw UsageError("--against and --surface are two surfaces; give one of them");
  }
  if (!check.against && !check.surface && is_set(typed.skin)) {
    throw UsageError("the options of a skin are of a mesh and its surface: add --against");
  }
  if (!check.certificate) return;
  if (!check.against) throw UsageError("--certificate is of a mesh and a molecule: add --against");
  check_not_input(*check.certificate, *check.against);
  check_not_input(*check.certificate, {.input = check.mesh});
}

/// The arguments of the command that was given, checked.
Arguments chosen(const CLI::App& app, AllArguments& all, Typed& typed) {
  if (app.got_subcommand("features")) set_feature_defaults(typed, all.features);
  if (typed.purpose) apply_preset(typed, all.mesh);
  auto& model_number = typed.skin.selection.model_number;
  if (model_number && app.got_subcommand("mesh")) {
    all.mesh.models = ModelSet::parsed(*model_number);
    if (all.mesh.models) model_number.reset();
  }
  for (MoleculeArguments* molecule :
       {&all.mesh.molecule, &all.features.mesh.molecule, &all.morse.molecule, &all.balls.molecule,
        &all.info.molecule, &all.against}) {
    finish(*molecule, molecule->input, typed.skin);
  }
  finish(all.view.molecule, all.view.against.value_or(all.view.molecule.input), typed.skin);
  // A size of any kind may need triangles as coarse as can be.
  const bool has_size_goal = typed.density || typed.triangles;
  const double default_C = has_size_goal ? certify::Sizing::coarsest_C : certify::Sizing().C;
  for (certify::Sizing* sizing : {&all.mesh.sizing, &all.features.mesh.sizing, &all.info.sizing,
                                  &all.check.sizing, &all.view.sizing}) {
    finish(*sizing, typed.skin, default_C);
  }
  for (Limits* limits : {&all.mesh.limits, &all.features.mesh.limits, &all.check.limits,
                         &all.view.limits, &all.render.limits}) {
    finish(*limits, typed);
  }
  const auto finished = [&](auto& arguments, const auto& as_typed) {
    finish(arguments, as_typed);
    return arguments;
  };
  if (app.got_subcommand("mesh")) return finished(all.mesh, typed);
  if (app.got_subcommand("features")) return finished(all.features, typed);
  if (app.got_subcommand("morse")) return finished(all.morse, typed);
  if (app.got_subcommand("view")) return finished(all.view, typed);
  if (app.got_subcommand("render")) return finished(all.render, typed.picture);
  if (app.got_subcommand("balls")) return finished(all.balls, typed);
  if (app.got_subcommand("info")) return all.info;
  if (app.got_subcommand("batch")) {
    all.batch.arguments.progress = parsed_progress(typed.progress);
    return batch_arguments(*app.get_subcommand("batch"), all.batch);
  }
  if (app.got_subcommand("figure")) {
    finish(all.figure);
    return all.figure;
  }
  if (!all.against.input.empty()) all.check.against = all.against;
  all.check.typed = typed.skin;
  finish(all.check, typed);
  return all.check;
}

}  // namespace

Arguments parse_arguments(int count, const char* const* words) {
  CLI::App app("", "morskin");
  app.failure_message([](const CLI::App* parser, const CLI::Error& error) {
    std::string meant;
    if (std::string_view(error.what()).starts_with("--model: ")) {
      meant = "; the model of a file that has several is --model-number";
    }
    for (const std::string& word : parser->remaining(true)) {
      const std::optional<std::string> option = nearest_option(*parser, word);
      if (option) meant += "; " + word + " is no option, did you mean " + *option + "?";
    }
    return "morskin: " + std::string(error.what()) + meant + "; see morskin --help\n";
  });
  AllArguments all;
  Typed typed;
  std::vector<const char*> completed(words, words + count);
  for (const std::string_view word : completed) {
    typed.wants_short_help |= word == "--help" || word == "-h";
  }
  add_commands(app, all, typed);
  try {
    const auto implied = implied_command(std::span(completed).subspan(1), app);
    if (implied) completed.insert(completed.begin() + 1, implied->c_str());
    all.info.is_implied = implied.has_value();
    app.parse(static_cast<int>(completed.size()), completed.data());
    return chosen(app, all, typed);
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
