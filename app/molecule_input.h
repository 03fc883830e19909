#pragma once

#include <string>
#include <vector>

#include "app/arguments.h"
#include "geometry/point.h"
#include "morskin/prepared_skin.h"
#include "skin/molecule.h"

namespace morskin::app {

/// A molecule and its weighted points under a model.
struct MoleculeInput {
  skin::Molecule molecule;
  std::string sha256;                           ///< of the file's bytes, unpacked
  std::vector<geometry::WeightedPoint> points;  ///< by atom, in the range of the exact predicates
  std::size_t rounded_coordinates = 0;          ///< to multiples of 2^-120 Angstrom
};

/// @throws geometry::UnreadableInput
/// @throws geometry::RefusedInput  also for an atom whose weight is out of the range of the exact
///                                 predicates
/// @throws UsageError              the model is Given and the file gives radii, or the other way
MoleculeInput read_input(const MoleculeArguments& arguments);

/// Tells on standard error of coordinates that had to be rounded.
void note_rounded_coordinates(const MoleculeInput& input);

/// Tells on standard error of radii that were listed, as in C=1.7, and of the letter of a location,
/// where no atom takes them: a slip more often than a wish. Tables in files are of many molecules.
void note_unused(const MoleculeArguments& arguments, const MoleculeInput& input);

/// morskin::prepare_skin, but a refusal calls the atoms by their names.
/// @throws geometry::RefusedInput
morskin::PreparedSkin prepare_skin(const MoleculeInput& input,
                                   const morskin::Run& run = morskin::Run());
/// Without the voids that the arguments leave out.
morskin::PreparedSkin prepare_skin(const MoleculeInput& input, const MoleculeArguments& arguments,
                                   const morskin::Run& run);

/// Smallest and largest radius of the atoms' sphere patches, Angstrom.
struct RadiusRange {
  double smallest, largest;
};
RadiusRange patch_radii(const std::vector<geometry::WeightedPoint>& points);

/// The number of atoms of the file that were left out.
std::size_t skipped(const skin::ReadingCounts& counts);

/// The reasons in words, "120 of other chains, 34 of water"; empty if nothing was left out.
std::string skipped_in_words(const skin::ReadingCounts& counts);

/// Which model of several was read, "the first of 20" or "number 3 of 20"; empty if there is one.
std::string model_in_words(const skin::ReadingCounts& counts, const skin::Selection& selection);

}  // namespace morskin::app
