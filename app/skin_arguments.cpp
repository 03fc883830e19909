#include "app/skin_arguments.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/report_lines.h"
#include "app/typed_values.h"
#include "geometry/error.h"
#include "skin/molecule_files.h"

namespace morskin::app {
namespace {

constexpr double largest_C = 1e150;    // of larger ones the default Q is not finite
constexpr double largest_probe = 1e4;  // Angstrom; keeps the weights in the predicates' range

/// A list of radii is checked here; a file when it is read.
void check_radii(const std::string& radii, const std::filesystem::path& molecule) {
  if (radii.empty()) throw UsageError("--radii is empty; name a table or a file");
  if (radii == "-" && molecule == "-") {
    throw UsageError("the molecule and --radii cannot both be standard input");
  }
  try {
    skin::parse_radius_table(radii);
  } catch (const geometry::RefusedInput& error) {
    throw UsageError(std::string("--radii: ") + error.what());
  }
}

void check_sizing(const certify::Sizing& sizing) {
  if (!(sizing.C >= certify::Sizing::min_C) || !std::isfinite(sizing.C)) {
    throw UsageError("-C must be at least 1e-5 and finite");
  }
  if (sizing.C > largest_C) throw UsageError("-C must be at most 1e150");
  if (!(sizing.Q > 1) || !std::isfinite(sizing.Q))
    throw UsageError("-Q must be above 1 and finite");
  if (!(2 * sizing.C < sizing.Q)) throw UsageError("-C must be below half of -Q");
}

}  // namespace

bool is_read_once(const std::filesystem::path& file) {
  std::error_code ignored;
  return file == "-" || file == "/dev/stdin" || std::filesystem::is_fifo(file, ignored);
}

std::string model_text(const MoleculeArguments& molecule) {
  const std::string model = "model " + std::string(skin::name_of(molecule.model));
  return skin::has_probe(molecule.model) ? model + ", probe " + brief(molecule.probe) + " A"
                                         : model;
}

void add_model(nlohmann::ordered_json& json, const MoleculeArguments& molecule) {
  json["model"] = skin::name_of(molecule.model);
  if (skin::has_probe(molecule.model)) json["probe"] = molecule.probe;
}

bool is_set(const TypedSkin& typed) {
  return is_of_molecules(typed) || typed.C || typed.Q || typed.size;
}

bool is_of_molecules(const TypedSkin& typed) {
  return typed.model || typed.radii || typed.voids || typed.probe || is_set(typed.selection);
}

void finish(MoleculeArguments& molecule, const std::filesystem::path& file,
            const TypedSkin& typed) {
  const bool gives_weights = skin::molecule_format_of(file) == skin::MoleculeFormat::Xyzw;
  if (typed.model) {
    molecule.model = *skin::parse_model(*typed.model);
  } else if (gives_weights) {
    molecule.model = skin::Model::Given;
  }
  if (gives_weights && molecule.model != skin::Model::Given) {
    throw UsageError(file.string() + " gives weights; leave out --model");
  }
  if (molecule.model == skin::Model::Given && typed.probe) {
    throw UsageError("weights that are given need no probe; leave out --probe");
  }
  molecule.selection = parsed(typed.selection);
  if (typed.radii) check_radii(*typed.radii, file);
  molecule.radii = typed.radii;
  if (typed.voids) molecule.drop_voids_below = parsed_voids(*typed.voids);
  molecule.probe = typed.probe.value_or(molecule.probe);
  if (!(molecule.probe >= 0 && molecule.probe <= largest_probe)) {
    throw UsageError("--probe must be from 0 to 10000 Angstrom");
  }
}

void finish(certify::Sizing& sizing, const TypedSkin& typed, double default_C) {
  if (typed.size && !(*typed.size >= certify::Sizing::min_size && std::isfinite(*typed.size))) {
    throw UsageError("--size must be at least 1e-6 Angstrom and finite");
  }
  sizing.C = typed.C.value_or(typed.size ? certify::Sizing::coarsest_C : default_C);
  sizing.Q = typed.Q.value_or(certify::Sizing::quality_for(sizing.C));
  check_sizing(sizing);
  if (typed.size) sizing.set_edge_length(*typed.size);
  if (!(sizing.largest_length_scale >= certify::Sizing::min_size)) {
    throw UsageError("--size must be larger, or -C smaller");
  }
}

}  // namespace morskin::app
