#pragma once

/// Radii of atoms by their element, or by their residue and name: published ones, or the user's.

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skin/molecule.h"
#include "skin/radii.h"

namespace morskin::skin {

/// Names a table of radii or lists one.
class RadiusTable {
 public:
  RadiusTable() = default;  ///< "elements"
  explicit RadiusTable(RadiusSource source) : source_(source) {}

  /// Adds a radius of the user's own; from then on no published one counts.
  /// @param key     an element, "C", or a residue and an atom's name, "ALA:CA"
  /// @param radius  Angstrom, above 0 and at most 10^6
  /// @return what is wrong with them, in words; then nothing is added
  std::optional<std::string> add(std::string_view key, std::string_view radius);

  /// By residue and name, or else by element; deuterium and tritium are hydrogen unless listed.
  /// @return Angstrom; nothing where the table has none
  std::optional<double> radius(const Atom& atom) const;

  /// "elements", "bondi", "alvarez", or what the atoms take of the user's own, "ALA:CA=1.9,C=1.7".
  /// Law: radius_table() of it gives the atoms the same radii.
  std::string text_for(std::span<const Atom> atoms) const;

  /// Of the user's own, the elements and names that none of the atoms takes a radius by, sorted.
  std::vector<std::string> unused_by(std::span<const Atom> atoms) const;

 private:
  const std::pair<const std::string, double>* entry_of(const Atom& atom) const;

  RadiusSource source_ = RadiusSource::Elements;
  std::map<std::string, double, std::less<>> own_;
};

/// The table called "elements", "bondi" or "alvarez", or listed as "C=1.7,ALA:CA=1.9"; nothing for
/// what looks like neither.
/// @throws geometry::RefusedInput  for a list with an entry that is wrong
std::optional<RadiusTable> parse_radius_table(std::string_view text);

/// A file with an element, or a residue and an atom, and a radius on each line; # begins a comment.
/// @throws geometry::UnreadableInput  "file:line: what is wrong"
RadiusTable read_radius_table(const std::filesystem::path& file);

/// The table of that name, listed so, or in that file.
/// @throws geometry::RefusedInput, geometry::UnreadableInput  as above
RadiusTable radius_table(const std::string& text);

}  // namespace morskin::skin
