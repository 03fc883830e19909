#pragma once

// Inside molecule_files: one parser per format. Each reports every atom of the model to read;
// common code (selection.cpp) decides afterwards which to leave out.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/files/text_lines.h"
#include "skin/molecule.h"
#include "skin/selection.h"

namespace morskin::skin::molecule_formats {

/// The wwPDB's element of an atom that was seen but not identified.
constexpr std::string_view unknown_element = "X";

/// An atom as in the file.
struct AtomRecord {
  Atom atom;          ///< without a radius if the format has none
  double weight = 0;  ///< Angstrom^2, in a file that gives weights
  double charge = 0;  ///< elementary charges, in a file that gives charges
  double occupancy = 1;
  char alternate = ' ';       ///< letter of the alternate location; blank if the atom has only one
  bool is_hetatm = false;     ///< read from a HETATM record
  Label assembly_chain = {};  ///< how assemblies call its chain: label_asym_id in mmCIF
  Label segment = {};         ///< in PDB, which tells apart what has no chain
};

struct ParsedFile {
  std::vector<AtomRecord> atoms;
  bool has_radii = false;
  bool has_weights = false;
  bool has_charges = false;
  // What the format tells of atoms:
  bool has_chains = false;
  bool has_hetatms = false;  ///< which come from HETATM records
  bool has_elements = false;
  bool has_locations = false;  ///< alternate ones
  /// The names that labels cut, whole, where the format has such.
  std::set<std::string> long_names = {};
};

/// Finds the model to read among a file's, which a parser tells it of in the file's order.
class ModelSearch {
 public:
  /// @param wanted  the number of a model; absent: the first
  explicit ModelSearch(std::optional<std::int64_t> wanted) : wanted_(wanted) {}
  /// None is to be read.
  static ModelSearch of_none() {
    ModelSearch search(std::nullopt);
    search.is_found_ = true;
    return search;
  }

  /// A model begins. Of several with one number the first counts.
  /// @param number  what the file calls it; absent: its place among all
  /// @return whether its atoms are to be read
  bool begin(std::optional<std::int64_t> number = std::nullopt);

  /// A data block with atoms after the first such, which nothing can ask for. Counts as a model.
  void pass_over() { ++passed_over_; }

  bool has_begun() const { return !numbers_.empty(); }
  /// Each once, in the file's order.
  /// @throws RefusedInput  for one that occurs twice, or that is passed over: the second could not
  ///                       be asked for
  std::vector<std::int64_t> numbers(const std::string& source) const;

  /// How many models are not to be read.
  /// @throws RefusedInput  the one wanted did not begin, though others did
  std::size_t others(const std::string& source) const;

 private:
  std::optional<std::int64_t> wanted_;
  std::vector<std::int64_t> numbers_;  // of all that began
  std::size_t passed_over_ = 0;
  bool is_found_ = false;
};

/// Each parses all bytes of a file; `source` is its name for messages. @throws UnreadableInput
ParsedFile parse_pdb(std::string_view bytes, const std::string& source, ModelSearch& models);
ParsedFile parse_mmcif(std::string_view bytes, const std::string& source, ModelSearch& models);
ParsedFile parse_pqr(std::string_view bytes, const std::string& source, ModelSearch& models);
ParsedFile parse_xyz(std::string_view bytes, const std::string& source, ModelSearch& models);
ParsedFile parse_xyzr(std::string_view bytes, const std::string& source, ModelSearch& models);
ParsedFile parse_xyzw(std::string_view bytes, const std::string& source, ModelSearch& models);

/// The atoms of the model to read in a file of records, as PDB and PQR have them.
/// @param format  its name, for messages
ParsedFile parse_records(std::string_view bytes, const std::string& source,
                         const std::string& format, bool (*is_atom)(std::string_view line),
                         AtomRecord (*atom_on)(const geometry::TextLines& lines),
                         ModelSearch& models);

/// Whether a word begins a PQR atom: ATOM or HETATM, a serial number sticking to it or not.
bool is_pqr_record(std::string_view word);

/// Begins a file of weights, which nothing else tells from one of radii.
constexpr std::string_view weights_line = "# x y z w";

/// The element of an atom by its name, where neither a symbol nor the name's columns tell it. The
/// first letter decides, but in a name that is also its residue's (an ion), where it is no element,
/// and for the heavier elements listed in pdb_file.cpp.
/// @return a symbol as in radii.h, or "" if unknown
std::string_view element_from_word(std::string_view name, std::string_view residue);

/// Keeps of every atom's alternate locations the one with the letter, if it is given and the atom
/// has it; otherwise that with the highest occupancy, of equals the one with the first letter. Of a
/// residue with several identities, one is kept by the same rule.
/// @return how many were removed
std::size_t keep_one_location(std::vector<AtomRecord>& atoms, std::optional<char> letter);

/// Leaves out what is not selected, and atoms of unknown element.
/// @return what was left out
/// @throws RefusedInput  nothing is left, or the file or its format lacks what the selection names
ReadingCounts keep_selected(ParsedFile& file, const Selection& selection,
                            const std::string& source);

}  // namespace morskin::skin::molecule_formats
