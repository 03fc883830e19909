#pragma once

/// The molecules that morskin.h makes skins of, and how they are read from files. Whatever goes
/// wrong is an Error, which is there.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace morskin {

using Point = std::array<double, 3>;  ///< a position or a direction; Angstrom, or unit length

struct Atom {
  Point position;
  double radius;  ///< van der Waals, > 0
};

/// Which atoms of a file to read, and with which radii.
struct ReadOptions {
  std::vector<std::string> chains = {};  ///< the author's names, "_" for none; empty: all
  bool waters = false;                   ///< with water
  /// The residues, water aside, whose HETATM records are read; absent: all.
  std::optional<std::vector<std::string>> hetatms = {};
  /// Of an atom's alternate locations: "likeliest", "all", or the letter of one.
  std::string locations = "likeliest";
  bool hydrogens = true;                     ///< with hydrogen, deuterium and tritium
  std::optional<std::int64_t> model = {};    ///< as the file numbers them; absent: the first
  std::optional<std::string> assembly = {};  ///< biological, by the file's name; absent: as it is
  /// "elements", "bondi", "alvarez", a list "C=1.7,ALA:CA=1.9", or a file of such lines; absent:
  /// the file's own radii, or else "elements". papers/molecules.md has more.
  std::optional<std::string> radii = {};
};

/// What a file tells of a molecule.
struct Molecule {
  std::vector<Atom> atoms;
  std::vector<double> charges;  ///< by atom, elementary charges, of a PQR file; else empty
  /// How many atoms were left out, by the reasons of the command's report. What has no radius has
  /// no skin, and its charge is lost with it: "zero_radii".
  std::vector<std::pair<std::string, std::size_t>> left_out;
};

/// The molecule in a PDB, mmCIF, PQR, XYZ or XYZR file, gzipped or not, in its order; "-" is
/// standard input.
/// @throws Error  Unreadable, Refused
Molecule read_molecule_file(const std::filesystem::path& file, const ReadOptions& options = {});
/// Its atoms.
/// @throws Error  Unreadable, Refused
std::vector<Atom> read_molecule(const std::filesystem::path& file, const ReadOptions& options = {});
/// The van der Waals radius of an element, Angstrom; nothing for what is none, or has none.
/// @param element  a symbol in upper or lower case
std::optional<double> van_der_waals_radius(std::string_view element);

}  // namespace morskin
