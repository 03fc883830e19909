#include "app/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/complaints.h"
#include "app/complex_files.h"
#include "app/features_options.h"
#include "app/implied_command.h"
#include "app/limits.h"
#include "app/mesh_arguments.h"
#include "app/options.h"
#include "app/output_names.h"
#include "app/presets.h"
#include "app/typed_values.h"
#include "geometry/files/mesh_files.h"
#include "skin/molecule_files.h"

namespace morskin::app {
namespace {

void finish(Limits& limits, const Typed& typed) {
  if (limits.timeout && !(*limits.timeout > 0 && *limits.timeout <= Limits::max_timeout)) {
    throw UsageError("--timeout must be above 0 and at most 1e8 seconds");
  }
  if (typed.max_memory) limits.max_memory = parsed_bytes(*typed.max_memory);
}

void finish(MorseArguments& morse, const Typed& typed) {
  check_not_input(morse.output, morse.molecule);
  if (!is_special(morse.output) && !complex_format_of(morse.output)) {
    throw UsageError(morse.output.string() + ": the ending must be .json or .vtu");
  }
  morse.function = parsed(typed);
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

/// The ending must not say that the bytes are what they are not.
void finish(BallsArguments& balls, const Typed&) {
  const auto format = skin::molecule_format_of(balls.output);
  if (balls.weights && format == skin::MoleculeFormat::Xyzr) {
    throw UsageError(balls.output.string() + ": with --weights the ending must be .xyzw");
  }
  if (!balls.weights && format == skin::MoleculeFormat::Xyzw) {
    throw UsageError(balls.output.string() + ": only --weights writes .xyzw");
  }
  const bool is_of_balls =
      format == skin::MoleculeFormat::Xyzr || format == skin::MoleculeFormat::Xyzw;
  const bool is_of_another = (format && !is_of_balls) || names_a_mesh(balls.output);
  if (is_of_another || lower_extension(balls.output) == ".gz") {
    throw UsageError(balls.output.string() +
                     ": balls are written as .xyzr or, with --weights, .xyzw");
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
}

void finish(FeaturesArguments& features, const Typed& typed) {
  finish_features(features);  // names the endings it takes, before mesh names all of its own
  finish(features.mesh, typed);
}

void finish(const CheckArguments& check, const Typed& typed) {
  // As of an unset variable of a script: without a molecule most of what can be wrong would pass.
  if (check.against && check.against->input.empty()) {
    throw UsageError("--against is empty; name the molecule");
  }
  if (check.surface && check.against) {
    throw UsageError("--against and --surface are two surfaces; give one of them");
  }
  const bool is_more_from_input =
      check.against && (check.against->input == "-" || check.against->radii == "-");
  if (check.mesh == "-" && is_more_from_input) {
    throw UsageError("the mesh and what it is checked by cannot both be standard input");
  }
  // -C, -Q and --size may be of the surface that the mesh states.
  if (!check.against && !check.surface && is_of_molecules(typed.skin)) {
    throw UsageError("the options of a skin are of a mesh and its molecule: add --against");
  }
  if (check.surface && is_of_molecules(typed.skin)) {
    throw UsageError("--surface goes without the options of molecules");
  }
  if (!check.certificate) return;
  if (!check.against) throw UsageError("--certificate is of a mesh and a molecule: add --against");
  if (check.json && is_standard_output(*check.certificate)) {
    throw UsageError("only one thing can go to standard output");
  }
  check_not_input(*check.certificate, *check.against);
  check_not_input(*check.certificate, {.input = check.mesh});
  for (const std::filesystem::path& partner : geometry::msms_partners(check.mesh)) {
    check_not_input(*check.certificate, {.input = partner});
  }
}

/// Texts that an empty word would leave as if they were not given.
constexpr std::array<std::string_view, 8> lost_if_empty{
    "--size", "--view", "--up", "--at", "--inset", "--colour", "--only", "--snapshot-dir"};

/// CLI11 takes an empty word for no number, so that an unset variable of a script would go unseen.
void check_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string type = option->get_type_name();
    const bool is_number =
        type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT");
    if (is_number && std::ranges::count(option->results(), "") > 0) {
      throw UsageError(option->get_name() + " is empty; give a number or leave it out");
    }
    const bool is_lost =
        std::ranges::find(lost_if_empty, option->get_name()) != lost_if_empty.end();
    if (is_lost && std::ranges::count(option->results(), "") > 0) {
      throw UsageError(option->get_name() + " is empty; leave it out or fill it");
    }
  }
}

/// The arguments of the command that was given, checked.
Arguments chosen(const CLI::App& app, AllArguments& all, Typed& typed) {
  check_values(*app.get_subcommands().front());
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
  for (ShowProgress* progress :
       {&all.mesh.progress, &all.features.mesh.progress, &all.morse.progress, &all.view.progress,
        &all.info.progress, &all.check.progress, &all.batch.arguments.progress}) {
    *progress = parsed_progress(typed.progress);
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
    return batch_arguments(*app.get_subcommand("batch"), all.batch);
  }
  if (app.got_subcommand("figure")) {
    finish(all.figure);
    return all.figure;
  }
  if (app.get_subcommand("check")->count("--against") > 0) all.check.against = all.against;
  all.check.typed = typed.skin;
  finish(all.check, typed);
  return all.check;
}

/// A probe that plays no part may be a mistake, or be given to runs with all models. What is not
/// typed may be stated by a mesh that is read.
void note_unused_probe(const CLI::App& app, const AllArguments& all, const TypedSkin& typed) {
  const bool may_be_stated = app.got_subcommand("check") || all.view.against;
  if (!typed.probe || (!typed.model && may_be_stated)) return;
  const auto usual =
      all.batch.arguments.features ? skin::Model::SesLike : MoleculeArguments().model;
  const auto model = typed.model ? *skin::parse_model(*typed.model) : usual;
  const CLI::Option* quiet = app.get_subcommands().front()->get_option_no_throw("--quiet");
  if (skin::has_probe(model) || (quiet != nullptr && quiet->count() > 0)) return;
  std::cerr << "morskin: note: model " << skin::name_of(model)
            << " has no probe, so --probe plays no part; models sas and paper have one\n";
}

/// The last words of a complaint: where the options of the command are explained.
std::string help_hint(const CLI::App& app, std::string command) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  if (command.empty() && !given.empty()) command = given[0]->get_name();
  return "; see morskin " + (command.empty() ? "" : command + " ") + "--help\n";
}

}  // namespace

Arguments parse_arguments(int count, const char* const* words) {
  return parse_arguments(count, words, "");
}

Arguments parse_arguments(int count, const char* const* words, const std::string& command) {
  CLI::App app("", "morskin");
  app.failure_message([&command](const CLI::App* parser, const CLI::Error& error) {
    return "morskin: " + complaint(*parser, error) + help_hint(*parser, command);
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
    if (implied) all.info.words.assign(words + 1, words + count);
    app.parse(static_cast<int>(completed.size()), completed.data());
    Arguments arguments = chosen(app, all, typed);
    note_unused_probe(app, all, typed.skin);
    return arguments;
  } catch (const CLI::ParseError& error) {
    const bool is_complaint = error.get_exit_code() != 0;
    app.exit(error, std::cout, std::cerr);
    return Finished{is_complaint ? ExitCode::Usage : ExitCode::Success};
  } catch (const UsageError& error) {
    std::cerr << "morskin: " << error.what() << help_hint(app, command);
    return Finished{ExitCode::Usage};
  }
}

}  // namespace morskin::app
