#pragma once

// Molecules from files of chemists.
//
// By default a reader keeps the first model, of alternate locations the likeliest, and hydrogens if
// present. It drops water, unless asked to keep it or there is nothing else, and always atoms of
// the element X (unknown). selection.h has what else can be asked. Radii come from the file (PQR,
// XYZR) or from a table (PDB, mmCIF, XYZ; radius_table.h); a file of weights (XYZW) has those in
// their place. Molecule::counts lists what was left out.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skin/molecule.h"
#include "skin/radius_table.h"
#include "skin/selection.h"

namespace morskin::skin {

enum class MoleculeFormat {
  Pdb,
  Mmcif,
  Pqr,   ///< PDB-like words with charge and radius, separated by white space
  Xyz,   ///< a count, a comment, "element x y z" per line
  Xyzr,  ///< "x y z r" per line, # for comments
  Xyzw,  ///< "x y z w" per line, w the weight, Angstrom^2; without an ending after "# x y z w"
};

/// The format that a file's ending stands for, in upper or lower case, with or without .gz.
std::optional<MoleculeFormat> molecule_format_of(const std::filesystem::path& path);

struct ReadOptions {
  Selection selection = {};
  /// Given, it also takes the place of a PQR file's radii. Absent: the file's or "elements".
  std::optional<RadiusTable> radii = {};
  std::optional<MoleculeFormat> format = {};  ///< absent: by the ending, else by the content
  bool are_weights = false;  ///< the fourth numbers of lines without an ending to tell
  /// Of the unpacked file: 26 million lines of 80 columns, ten times the largest entry of the PDB
  /// (3J3Q, 2.4 million atoms).
  std::size_t max_bytes = std::size_t{1} << 31;
};

/// Reads the molecule in a file; "-" is standard input. Gzipped files are unpacked whatever their
/// name.
///
/// Law:    every atom's coordinates are finite and at most 10^6 Angstrom in magnitude, and its
///         radius is positive and at most 10^6 Angstrom, its weight, if given, at most 2^30.
/// @throws UnreadableInput  for a file that is missing, empty, damaged or of no format known here
/// @throws RefusedInput     if no atom is left, the selection asks for what the file or its format
///                          does not have, a number is out of range, or an atom has no radius;
///                          names the atom and its line
Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options = {});

/// The molecule in `bytes`, gzipped or not.
///
/// @param source  the name for messages; its ending chooses the format.
/// @throws UnreadableInput, RefusedInput  as above
Molecule parse_molecule(std::string_view bytes, const std::string& source,
                        const ReadOptions& options = {});

/// The numbers of the models in the file, each once, in its order: what the file calls them, or
/// their places. Selection::model plays no part.
/// @throws UnreadableInput, RefusedInput  as above
std::vector<std::int64_t> model_numbers(std::string_view bytes, const std::string& source,
                                        const ReadOptions& options = {});

}  // namespace morskin::skin
