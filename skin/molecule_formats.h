#pragma once

// Inside molecule_files: one parser per format. Each reports every atom of the first model; common
// code decides afterwards which to leave out.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/files/text_lines.h"
#include "skin/molecule.h"

namespace morskin::skin::molecule_formats {

/// The wwPDB's element of an atom that was seen but not identified.
constexpr std::string_view unknown_element = "X";

/// An atom as in the file.
struct AtomRecord {
  Atom atom;          ///< without a radius if the format has none
  double weight = 0;  ///< Angstrom^2, in a file that gives weights
  double occupancy = 1;
  char alternate = ' ';  ///< letter of the alternate location; blank if the atom has only one
};

struct ParsedFile {
  std::vector<AtomRecord> atoms;
  std::size_t other_models = 0;
  bool has_radii = false;
  bool has_weights = false;
};

/// Each parses all bytes of a file; `source` is its name for messages. @throws UnreadableInput
ParsedFile parse_pdb(std::string_view bytes, const std::string& source);
ParsedFile parse_mmcif(std::string_view bytes, const std::string& source);
ParsedFile parse_pqr(std::string_view bytes, const std::string& source);
ParsedFile parse_xyz(std::string_view bytes, const std::string& source);
ParsedFile parse_xyzr(std::string_view bytes, const std::string& source);
ParsedFile parse_xyzw(std::string_view bytes, const std::string& source);

/// The atoms of the first model in a file of records, as PDB and PQR have them.
/// @param format  its name, for messages
ParsedFile parse_records(std::string_view bytes, const std::string& source,
                         const std::string& format, bool (*is_atom)(std::string_view line),
                         AtomRecord (*atom_on)(const geometry::TextLines& lines));

/// Begins a file of weights, which nothing else tells from one of radii.
constexpr std::string_view weights_line = "# x y z w";

/// The element of an atom in a PDB file whose element columns are missing or wrong.
///
/// @param name     columns 13-16 untrimmed: an element of one letter starts in the second.
/// @param residue  in standard residues the first letter decides, wherever the name begins.
/// @return a symbol as in radii.h, or "" if unknown
std::string_view element_from_name(std::string_view name, std::string_view residue);

/// The same for a name without its columns: the first letter decides unless the name has four.
std::string_view element_from_word(std::string_view name, std::string_view residue);

/// Whether the residue is one of the standard amino acids or nucleotides.
bool is_standard_residue(std::string_view residue);

/// Keeps of every atom's alternate locations the one with the highest occupancy, of equals the one
/// with the first letter; of a residue with several identities only the likeliest.
/// @return how many were removed
std::size_t keep_likeliest_locations(std::vector<AtomRecord>& atoms);

}  // namespace morskin::skin::molecule_formats
