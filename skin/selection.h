#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morskin::skin {

/// Which of a file's atoms are read. Each member leaves atoms out for a reason of its own, and the
/// default is what a reader of most files wants.
///
/// Law: an atom is read if every member keeps it, where a location is the likeliest of those that
///      the members above it leave.
struct Selection {
  /// The author's names of the chains to keep, "_" for that of atoms without one; empty: all.
  std::vector<std::string> chains = {};

  bool waters = false;  ///< keep water; a file of nothing else keeps it anyway

  /// The residues, water aside, whose HETATM records are kept; it may be empty. Absent: all.
  std::optional<std::vector<std::string>> hetatms = {};

  bool all_locations = false;         ///< keep every alternate location of an atom; otherwise one:
  std::optional<char> location = {};  ///< that of this letter, or else the likeliest

  bool hydrogens = true;  ///< keep hydrogen, deuterium and tritium

  /// The number that the file gives the model, or its place in a file without numbers; absent: the
  /// first.
  std::optional<std::int64_t> model = {};

  /// The file's name of a biological assembly: its copies of the atoms read take their place, those
  /// of chain A called A, A-2, A-3 and so on. Absent: the atoms as they are in the file.
  std::optional<std::string> assembly = {};
};

/// Whether residues of this name are water.
bool is_water_residue(std::string_view residue);

/// The numbers of models for a message, ascending: "1 to 3, 7".
std::string listed_models(std::vector<std::int64_t> numbers);

}  // namespace morskin::skin
