#pragma once

// Inside molecule_files: one parser per format. They report every atom of the first model; what to
// leave out is decided afterwards, alike for all.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "skin/molecule.h"

namespace morskin::skin::molecule_formats {

/// What the wwPDB writes for the element of an atom that was seen but not identified.
constexpr std::string_view unknown_element = "X";

/// An atom as the file has it.
struct AtomRecord {
  Atom atom;  ///< its radius, if the format gives none, is still to come
  double occupancy = 1;
  char alternate = ' ';  ///< the letter of this place of the atom; blank if it has one only
};

struct ParsedFile {
  std::vector<AtomRecord> atoms;
  std::size_t other_models = 0;
  bool has_radii = false;
};

/// Each takes all bytes of a file and its name, and throws UnreadableInput.
ParsedFile parse_pdb(std::string_view bytes, const std::string& source);
ParsedFile parse_mmcif(std::string_view bytes, const std::string& source);
ParsedFile parse_pqr(std::string_view bytes, const std::string& source);
ParsedFile parse_xyz(std::string_view bytes, const std::string& source);
ParsedFile parse_xyzr(std::string_view bytes, const std::string& source);

/// The element of an atom in a PDB file whose element columns are missing or wrong.
///
/// @param name     columns 13-16 as they are: an element of one letter starts in the second.
/// @param residue  in standard residues the first letter decides, wherever the name begins.
/// @return a symbol as in radii.h, or "" if it cannot be told.
std::string_view element_from_name(std::string_view name, std::string_view residue);

/// The same for a name without its columns: the first letter decides unless the name has four.
std::string_view element_from_word(std::string_view name, std::string_view residue);

/// Whether the residue is one of the standard amino acids or nucleotides.
bool is_standard_residue(std::string_view residue);

/// Leaves of every atom with alternate places the one with the highest occupancy, of equals the one
/// with the first letter. Where a residue has several identities only the likeliest stays.
/// @return how many were left out
std::size_t keep_likeliest_places(std::vector<AtomRecord>& atoms);

}  // namespace morskin::skin::molecule_formats
