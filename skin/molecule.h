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

/// Up to eight characters, stored in place; a longer text loses its end.
class Label {
 public:
  Label() = default;
  explicit Label(std::string_view text) { text.copy(letters_.data(), letters_.size()); }

  std::string_view view() const {
    const std::string_view all(letters_.data(), letters_.size());
    return all.substr(0, all.find('\0'));
  }
  bool is_empty() const { return letters_[0] == '\0'; }
  friend auto operator<=>(const Label&, const Label&) = default;

 private:
  std::array<char, 8> letters_{};  // the unused ones are zero
};

/// A ball of the molecule, and whence it came. What the file does not tell is empty.
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

/// What a file held and the molecule does not, and what may surprise.
struct ReadingCounts {
  std::size_t waters = 0;        ///< atoms of water left out
  std::size_t alternates = 0;    ///< atoms left out for a likelier place of the same atom
  std::size_t zero_radii = 0;    ///< atoms left out because the file gives radius 0
  std::size_t unknown = 0;       ///< atoms left out because the file calls their element X, unknown
  std::size_t other_models = 0;  ///< models after the first, left out whole
  std::size_t duplicates = 0;    ///< atoms kept though an earlier one has their place and radius
};

/// The atoms of the first model of a file, in the file's order.
struct Molecule {
  std::vector<Atom> atoms;
  std::string source;  ///< the file's name
  ReadingCounts counts;
};

/// An atom in words, "atom CA of ALA 12 chain A (line 345)", as far as the file tells.
std::string describe(const Atom& atom);

/// The same; an atom whose line is unknown is told by its place in the molecule, from 1.
std::string describe(const Molecule& molecule, geometry::AtomId atom);

}  // namespace morskin::skin
