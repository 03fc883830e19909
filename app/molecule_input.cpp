#include "app/molecule_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skin/molecule_files.h"
#include "skin/singular_skin.h"

namespace morskin::app {
namespace {

constexpr double largest_weight = 1 << 30;  // Angstrom^2; geometry/predicates.h

}  // namespace

MoleculeInput read_input(const MoleculeArguments& arguments) {
  MoleculeInput input;
  skin::ReadOptions options;
  options.waters = arguments.waters;
  input.molecule = skin::read_molecule(arguments.input, options);
  input.points = skin::weighted_points(input.molecule, arguments.model, arguments.probe);
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const double weight = input.points[i].weight;
    if (weight > 0 && weight <= largest_weight) continue;
    throw geometry::RefusedInput(
        input.molecule.source + ": " + describe(input.molecule, geometry::AtomId{i}) +
        (weight > 0 ? " has too big a radius; give lengths in Angstrom"
                    : " has so small a radius that its weight rounds to 0; remove it"));
  }
  return input;
}

morskin::PreparedSkin prepare_skin(const MoleculeInput& input, const morskin::Progress& progress,
                                   unsigned threads) {
  try {
    return morskin::prepare_skin(input.points, progress, threads);
  } catch (const skin::SingularSkin& singular) {
    std::string names;
    for (const geometry::AtomId atom : singular.atoms) {
      names += (names.empty() ? "" : ", ") + describe(input.molecule, atom);
    }
    throw geometry::RefusedInput(
        input.molecule.source + ": the skin is singular at " + names +
        ": it touches itself there; change a radius or the probe a little");
  }
}

RadiusRange patch_radii(const std::vector<geometry::WeightedPoint>& points) {
  const auto [least, most] =
      std::ranges::minmax_element(points, {}, &geometry::WeightedPoint::weight);
  return {skin::patch_radius(least->weight), skin::patch_radius(most->weight)};
}

std::size_t skipped(const skin::ReadingCounts& counts) {
  return counts.waters + counts.alternates + counts.zero_radii + counts.unknown;
}

std::string skipped_in_words(const skin::ReadingCounts& counts) {
  std::string words;
  for (const auto& [count, what] : {std::pair(counts.waters, " of water"),
                                    std::pair(counts.alternates, " in alternate locations"),
                                    std::pair(counts.zero_radii, " of radius 0"),
                                    std::pair(counts.unknown, " of unknown element")}) {
    if (count > 0) words += (words.empty() ? "" : ", ") + std::to_string(count) + what;
  }
  return words;
}

}  // namespace morskin::app
