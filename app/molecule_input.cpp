#include "app/molecule_input.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "app/report_lines.h"
#include "app/sha256.h"
#include "geometry/exact_range.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/gzip.h"
#include "morskin/voids.h"
#include "skin/molecule_files.h"
#include "skin/singular_skin.h"

namespace morskin::app {
namespace {

using geometry::WeightedPoint;

/// The first atom that has a coordinate with too many digits for the exact predicates.
std::optional<geometry::AtomId> first_inexact(const skin::Molecule& molecule) {
  const auto first = std::ranges::find_if(molecule.atoms, [](const skin::Atom& atom) {
    return !std::ranges::all_of(atom.position, geometry::is_exact_coordinate);
  });
  if (first == molecule.atoms.end()) return std::nullopt;
  return geometry::AtomId(static_cast<std::size_t>(first - molecule.atoms.begin()));
}

/// Files hold noise like 1e-25 for 0; rounding it moves an atom by 2^-121 Angstrom at most.
std::size_t round_coordinates(const skin::Molecule& molecule, std::vector<WeightedPoint>& points) {
  const std::optional<geometry::AtomId> first = first_inexact(molecule);
  if (!first) return 0;
  const std::size_t count = geometry::move_to_exact_grid(points);
  if (count == 0) {
    throw geometry::RefusedInput(
        molecule.source + ": " + describe(molecule, *first) +
        " has a coordinate with digits below 2^-120 Angstrom, and radii are too small for it to be "
        "rounded; give larger lengths");
  }
  return count;
}

void check_weights(const MoleculeInput& input) {
  const std::string given = input.molecule.weights.empty() ? "radius" : "weight";
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const double weight = input.points[i].weight;
    if (weight >= morskin::least_provable_weight && geometry::is_exact_weight(weight)) continue;
    throw geometry::RefusedInput(
        input.molecule.source + ": " + describe(input.molecule, geometry::AtomId{i}) +
        (weight > geometry::largest_exact
             ? " has too big a radius; give lengths in Angstrom"
             : " has so small a " + given + " that nothing can be proved of its skin; remove it"));
  }
}

std::string listed(const skin::Molecule& molecule, const std::vector<geometry::AtomId>& atoms) {
  std::string names;
  for (const geometry::AtomId atom : atoms) {
    names += (names.empty() ? "" : ", ") + describe(molecule, atom);
  }
  return names;
}

/// skin::parse_molecule; of a file with the name of a mesh it is also told which command takes one.
skin::Molecule parsed_molecule(std::string_view bytes, const std::string& name,
                               const skin::ReadOptions& options) {
  try {
    return skin::parse_molecule(bytes, name, options);
  } catch (const geometry::UnreadableInput& error) {
    if (!names_a_mesh(name)) throw;
    throw geometry::UnreadableInput(std::string(error.what()) +
                                    "; to check a mesh: morskin check " + name);
  }
}

}  // namespace

MoleculeInput read_input(const MoleculeArguments& arguments) {
  MoleculeInput input;
  skin::ReadOptions options;
  options.selection = arguments.selection;
  options.are_weights = arguments.model == skin::Model::Given;
  if (arguments.radii) options.radii = skin::radius_table(*arguments.radii);
  const std::string name = arguments.input.string();
  const geometry::FileBytes file = geometry::read_file(arguments.input, options.max_bytes);
  std::string_view bytes = file.view();
  std::string unpacked;
  if (geometry::is_gzip(bytes)) {
    bytes = unpacked = geometry::unpack_gzip(bytes, name, options.max_bytes);
  }
  input.sha256 = sha256_of(bytes);
  input.molecule = parsed_molecule(bytes, name, options);
  const bool gives_weights = !input.molecule.weights.empty();
  if (gives_weights != (arguments.model == skin::Model::Given)) {
    throw UsageError(input.molecule.source + (gives_weights
                                                  ? " gives weights; add --model given"
                                                  : " gives no weights; take another --model"));
  }
  input.points = skin::weighted_points(input.molecule, arguments.model, arguments.probe);
  check_weights(input);
  input.rounded_coordinates = round_coordinates(input.molecule, input.points);
  return input;
}

void note_rounded_coordinates(const MoleculeInput& input) {
  if (input.rounded_coordinates == 0) return;
  const skin::Molecule& molecule = input.molecule;
  std::cerr << "morskin: note: " << molecule.source << ": coordinates below 2^-68 Angstrom were "
            << "rounded to multiples of 2^-120: " << input.rounded_coordinates << ", the first of "
            << describe(molecule, *first_inexact(molecule)) << "\n";
}

void note_unused(const MoleculeArguments& arguments, const MoleculeInput& input) {
  const std::optional<char> location = arguments.selection.location;
  if (location && input.molecule.counts.at_location == 0) {
    std::cerr << "morskin: note: " << input.molecule.source << ": no atom has a location "
              << *location << ", so the likeliest are kept\n";
  }
  const auto list = arguments.radii ? skin::parse_radius_table(*arguments.radii) : std::nullopt;
  if (!list) return;
  constexpr std::size_t most = 5;
  const std::vector<std::string> unused = list->unused_by(input.molecule.atoms);
  if (unused.empty()) return;
  std::string names;
  for (const std::string& name : std::span(unused).first(std::min(most, unused.size()))) {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (unused.size() > most) names += " and " + std::to_string(unused.size() - most) + " more";
  std::cerr << "morskin: note: " << input.molecule.source << ": no atom takes the radius of "
            << names << "\n";
}

morskin::PreparedSkin prepare_skin(const MoleculeInput& input, const morskin::Run& run) {
  try {
    return morskin::prepare_skin(input.points, run);
  } catch (const skin::SingularSkin& singular) {
    throw geometry::RefusedInput(
        input.molecule.source + ": the skin is singular at " +
        listed(input.molecule, singular.atoms) +
        ": it touches itself there; change a radius or the probe a little");
  } catch (const morskin::UnresolvedNeck& neck) {
    throw geometry::RefusedInput(
        input.molecule.source + ": between " + listed(input.molecule, neck.atoms) +
        " the skin is thinner than coordinates resolve there: move the molecule to the origin");
  } catch (const morskin::ScalesTooFarApart& apart) {
    throw geometry::RefusedInput(
        input.molecule.source + ": " + describe(input.molecule, apart.small) +
        " has a patch over 2^36 times smaller than " +
        (apart.small == apart.largest
             ? "its largest coordinate: doubles cannot carry both; move the molecule to the origin"
             : "the largest coordinate, that of " + describe(input.molecule, apart.largest) +
                   ": doubles cannot carry both; mesh them from two files"));
  }
}

morskin::PreparedSkin prepare_skin(const MoleculeInput& input, const MoleculeArguments& arguments,
                                   const morskin::Run& run) {
  morskin::PreparedSkin skin = prepare_skin(input, run);
  morskin::drop_voids(skin, arguments.drop_voids_below, run);
  return skin;
}

RadiusRange patch_radii(const std::vector<geometry::WeightedPoint>& points) {
  const auto [least, most] =
      std::ranges::minmax_element(points, {}, &geometry::WeightedPoint::weight);
  return {skin::patch_radius(least->weight), skin::patch_radius(most->weight)};
}

std::size_t skipped(const skin::ReadingCounts& counts) {
  return counts.other_chains + counts.waters + counts.hetatms + counts.alternates +
         counts.hydrogens + counts.zero_radii + counts.unknown;
}

std::string model_in_words(const skin::ReadingCounts& counts, const skin::Selection& selection) {
  if (counts.other_models == 0) return "";
  return (selection.model ? "number " + std::to_string(*selection.model) : "the first") + " of " +
         grouped(counts.other_models + 1);
}

std::string skipped_in_words(const skin::ReadingCounts& counts) {
  std::string words;
  for (const auto& [count, what] :
       {std::pair(counts.other_chains, " of other chains"), std::pair(counts.waters, " of water"),
        std::pair(counts.hetatms, " of HETATM records"),
        std::pair(counts.alternates, " in alternate locations"),
        std::pair(counts.hydrogens, " of hydrogen"), std::pair(counts.zero_radii, " of radius 0"),
        std::pair(counts.unknown, " of unknown element")}) {
    if (count > 0) words += (words.empty() ? "" : ", ") + grouped(count) + what;
  }
  return words;
}

}  // namespace morskin::app
