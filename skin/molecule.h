#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::skin {

/// Up to eight characters, without allocation; a longer text is cut.
class Label {
 public:
  static constexpr std::size_t max_size = 8;  ///< of longer names the first so many characters

  Label() = default;
  explicit Label(std::string_view text) { text.copy(letters_.data(), letters_.size()); }

  std::string_view view() const {
    const std::string_view all(letters_.data(), letters_.size());
    return all.substr(0, all.find('\0'));
  }
  bool is_empty() const { return letters_[0] == '\0'; }
  friend auto operator<=>(const Label&, const Label&) = default;

 private:
  std::array<char, max_size> letters_{};  // the unused ones are zero
};

/// A ball of the molecule with its description in the file; missing fields are empty.
struct Atom {
  geometry::Point position;  ///< Angstrom
  double radius = 0;         ///< Angstrom: van der Waals, or as the file gives it
  Label element;             ///< "C", "Cl", "D"
  Label name;                ///< "CA"
  Label residue;             ///< "ALA"
  Label residue_number;      ///< with its insertion code: "12", "12A"
  Label chain;               ///< "A"
  std::uint32_t line = 0;    ///< of the file, from 1; 0 if unknown
};

/// Atoms and models of a file that were left out, and duplicates and locations that were kept.
struct ReadingCounts {
  std::size_t other_chains = 0;  ///< atoms left out for their chain, or in no part of the assembly
  std::size_t waters = 0;        ///< atoms of water left out
  std::size_t hetatms = 0;       ///< atoms left out for their HETATM record
  std::size_t alternates = 0;    ///< atoms left out for another of their alternate locations
  std::size_t at_location = 0;   ///< atoms kept that are at the location of the letter asked for
  std::size_t hydrogens = 0;     ///< atoms of hydrogen left out
  std::size_t zero_radii = 0;    ///< atoms left out for a radius of 0 in the file
  std::size_t unknown = 0;       ///< atoms left out for the element X, unknown
  std::size_t other_models = 0;  ///< models that were left out whole
  std::size_t duplicates = 0;    ///< atoms kept though an earlier one has their position and radius
};

/// The atoms of one model of a file, in the file's order.
struct Molecule {
  std::vector<Atom> atoms;
  /// By atom, Angstrom^2, of a file that gives weights, which are no model's; their radii are those
  /// of the patches, sqrt(w / 2). Empty for all other files.
  std::vector<double> weights;
  /// By atom, in units of the elementary charge, of a PQR file. Empty for all other files.
  std::vector<double> charges;
  /// Where the radii come from: "input" and "weights", of the file; or a table (radius_table.h).
  std::string radii;
  std::string source;  ///< the file's name
  ReadingCounts counts;
};

/// An atom in words, "atom CA of ALA 12 chain A (line 345)", without missing fields.
std::string describe(const Atom& atom);

/// The same; if its line is unknown, with the atom's index in the molecule, from 1.
std::string describe(const Molecule& molecule, geometry::AtomId atom);

}  // namespace morskin::skin
