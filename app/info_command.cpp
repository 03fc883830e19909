#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands.h"
#include "app/molecule_input.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/selection_arguments.h"
#include "app/strict_json.h"
#include "geometry/regular_triangulation.h"
#include "morskin/method.h"
#include "morskin/size_estimate.h"

namespace morskin::app {
namespace {

// Atoms by element, "?" if unknown.
std::map<std::string, std::size_t> elements(const skin::Molecule& molecule) {
  std::map<std::string, std::size_t> counts;
  for (const skin::Atom& atom : molecule.atoms)
    ++counts[atom.element.is_empty() ? "?" : std::string(atom.element.view())];
  return counts;
}

// The peak memory of a run by the usual method (papers/4.3-large-molecules.md).
double estimated_bytes(std::size_t balls, morskin::Method method, double triangles) {
  const bool is_static = method == morskin::Method::Static;
  const double per_atom = is_static ? 14'000 : 1500, per_triangle = is_static ? 500 : 150;
  constexpr double program = 12 << 20;  // itself, its libraries and what is read in one go
  return program + per_atom * static_cast<double>(balls) + per_triangle * triangles;
}

/// What a mesh will have, about.
struct Estimate {
  double triangles, bytes;
};

struct Info {
  RadiusRange radii;    ///< of the atoms
  RadiusRange patches;  ///< of their sphere patches
  std::size_t hidden;
  std::optional<SkinParts> parts;
  std::optional<Estimate> estimate;
  std::string refusal;  ///< why there is no skin, and so neither of these
};

Info gather(const MoleculeInput& input, const InfoArguments& arguments) {
  const auto [least, most] =
      std::ranges::minmax_element(input.molecule.atoms, {}, &skin::Atom::radius);
  Info info{{least->radius, most->radius}, patch_radii(input.points), 0, {}, {}, ""};
  ProgressLine progress(arguments.progress);
  const morskin::Run run(arguments.threads, progress.callback());
  try {
    const morskin::PreparedSkin skin = prepare_skin(input, arguments.molecule, run);
    info.hidden = skin.surface.triangulation().hidden.size();
    const morskin::Method method = morskin::usual_method(input.points, arguments.sizing);
    const double triangles = 2 * morskin::SizeEstimate(skin).vertices(arguments.sizing, method);
    info.estimate = {triangles, estimated_bytes(input.points.size(), method, triangles)};
    info.parts = skin_parts(skin, run);
  } catch (const geometry::RefusedInput& refused) {
    info.hidden = geometry::regular_triangulation(input.points).hidden.size();
    info.refusal = refused.what();
  }
  return info;
}

std::string json_text(const MoleculeInput& input, const InfoArguments& arguments,
                      const Info& info) {
  const skin::ReadingCounts& counts = input.molecule.counts;
  nlohmann::ordered_json json = {{"input", arguments.molecule.input.string()}};
  add_model(json, arguments.molecule);
  json.update({{"radii", input.molecule.radii},
               {"atoms", input.molecule.atoms.size()},
               {"elements", elements(input.molecule)},
               {"radius_min", rounded(info.radii.smallest)},
               {"radius_max", rounded(info.radii.largest)},
               {"patch_radius_min", rounded(info.patches.smallest)},
               {"patch_radius_max", rounded(info.patches.largest)},
               {"duplicates", counts.duplicates},
               {"hidden", info.hidden},
               {"coordinates_rounded", input.rounded_coordinates},
               {"skipped", skipped(counts)},
               {"skipped_other_chains", counts.other_chains},
               {"skipped_waters", counts.waters},
               {"skipped_hetatms", counts.hetatms},
               {"skipped_alternates", counts.alternates},
               {"skipped_hydrogens", counts.hydrogens},
               {"skipped_zero_radii", counts.zero_radii},
               {"skipped_unknown_elements", counts.unknown},
               {"skipped_models", counts.other_models},
               {"C", arguments.sizing.C},
               {"Q", arguments.sizing.Q}});
  if (info.estimate) {
    json["estimated_triangles"] = std::round(rounded(info.estimate->triangles, 2));
    json["estimated_bytes"] = std::round(rounded(info.estimate->bytes, 2));
  }
  add_selection(json, arguments.molecule.selection);
  if (info.parts) add_skin_parts(json, *info.parts);
  if (!info.parts) json["refused"] = info.refusal;
  return strict_json(json);
}

/// A word as a shell takes it for one.
std::string shell_word(const std::string& word) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_@%+=:,./-";
  if (word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// What a newcomer types to have the mesh of what was typed.
std::string next_step(const std::filesystem::path& input, std::vector<std::string> words) {
  const bool is_named = input != "-";
  std::filesystem::path mesh = is_named ? input.filename() : "mesh";
  if (mesh.extension() == ".gz") mesh = mesh.stem();
  // Behind "--", where inputs stand, it would be no option.
  words.insert(std::ranges::find(words, "--"), {"-o", mesh.replace_extension(".ply").string()});
  std::string command = "morskin";
  for (const std::string& word : words) command.append(" ").append(shell_word(word));
  return command + " writes the mesh; all options: morskin mesh --help";
}

std::string estimate_text(const Estimate& estimate) {
  constexpr double max_in_digits = 1e15;
  const double triangles = rounded(estimate.triangles, 2);
  const std::string number =
      triangles < max_in_digits ? grouped(std::llround(triangles)) : brief(triangles, 2);
  return line("triangles", "about " + number + ", by the skin's area and length scales") +
         line("memory", "about " + brief(rounded(estimate.bytes / (1 << 20), 2)) +
                            " MiB with so many triangles");
}

std::string people_text(const MoleculeInput& input, const InfoArguments& arguments,
                        const Info& info) {
  const skin::ReadingCounts& counts = input.molecule.counts;
  std::string composition;
  for (const auto& [element, count] : elements(input.molecule))
    composition += (composition.empty() ? "" : ", ") + grouped(count) + " " + element;
  const std::string words = skipped_in_words(counts);
  std::string text = arguments.molecule.input.string() + "\n";
  text += line("atoms", grouped(input.molecule.atoms.size()) + " (" + composition + ")");
  text += line("left out", words.empty() ? "none" : words);
  const std::string model = model_in_words(counts, arguments.molecule.selection);
  if (!model.empty()) text += line("models", model);
  const std::string& radii = input.molecule.radii;
  text += line("radii", brief(info.radii.smallest) + " to " + brief(info.radii.largest) + " A, " +
                            (radii == "input"     ? "as in the file"
                             : radii == "weights" ? "by the weights in the file"
                                                  : "of the table " + radii));
  text += line("patches", brief(info.patches.smallest) + " to " + brief(info.patches.largest) +
                              " A, " + model_text(arguments.molecule));
  text += line("duplicates", grouped(counts.duplicates));
  text += line("hidden", grouped(info.hidden) + " (no power cell, duplicates included)");
  text += info.parts ? skin_parts_text(*info.parts) : line("refused", info.refusal);
  if (info.estimate) text += estimate_text(*info.estimate);
  if (!arguments.words.empty()) {
    text += line("next", next_step(arguments.molecule.input, arguments.words));
  }
  return text;
}

}  // namespace

ExitCode info_command(const InfoArguments& arguments) {
  const MoleculeInput input = read_input(arguments.molecule);
  note_rounded_coordinates(input);
  note_unused(arguments.molecule, input);
  const Info info = gather(input, arguments);
  std::cout << (arguments.json ? json_text(input, arguments, info)
                               : people_text(input, arguments, info));
  return ExitCode::Success;
}

}  // namespace morskin::app
