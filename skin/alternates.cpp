// Alternate locations: one atom at several positions, each with a letter.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "skin/molecule_formats.h"

namespace morskin::skin::molecule_formats {
namespace {

// One of an atom's alternate locations.
struct Location {
  std::size_t index;  // in the file
  Label chain;        // or what tells its atoms from others where they have none
  Label place;        // in the chain: the residue's number or, where it has none, its name
  Label name;         // deuterium as hydrogen: where H and D share a site, it is one atom
  std::size_t copy;   // files made by symmetry may repeat chain, number and letter
  const AtomRecord* record;

  auto residue_key() const { return std::tie(chain, place); }
  auto atom_key() const { return std::tie(chain, place, name); }
};

// Whether `a` is to be kept rather than `b`.
bool is_better(const AtomRecord& a, const AtomRecord& b, std::optional<char> letter) {
  if ((a.alternate == letter) != (b.alternate == letter)) return a.alternate == letter;
  if (a.occupancy != b.occupancy) return a.occupancy > b.occupancy;
  return a.alternate < b.alternate;
}

Location location_of(const AtomRecord& record, std::size_t index) {
  std::string name(record.atom.name.view());
  const std::size_t letter = name.find_first_not_of("0123456789");
  if (record.atom.element.view() == "D" && letter != std::string::npos && name[letter] == 'D') {
    name[letter] = 'H';
  }
  const Atom& atom = record.atom;
  const Label& place = atom.residue_number.is_empty() ? atom.residue : atom.residue_number;
  const Label& part = record.segment.is_empty() ? record.assembly_chain : record.segment;
  return {index, atom.chain.is_empty() ? part : atom.chain, place, Label(name), 0, &record};
}

// Marks the locations of all identities but each residue's best.
void mark_other_residues(const std::vector<Location>& locations, std::optional<char> letter,
                         std::vector<bool>& is_out) {
  for (std::size_t first = 0, last = 0; first < locations.size(); first = last) {
    const Location* best = &locations[first];
    for (last = first; last < locations.size(); ++last) {
      if (locations[last].residue_key() != locations[first].residue_key()) break;
      if (is_better(*locations[last].record, *best->record, letter)) best = &locations[last];
    }
    for (std::size_t i = first; i < last; ++i) {
      if (locations[i].record->atom.residue != best->record->atom.residue) {
        is_out[locations[i].index] = true;
      }
    }
  }
}

// Numbers the locations that repeat an atom and a letter.
void number_copies(std::vector<Location>& locations) {
  for (std::size_t i = 1; i < locations.size(); ++i) {
    const Location& before = locations[i - 1];
    const bool is_repeated = before.atom_key() == locations[i].atom_key() &&
                             before.record->alternate == locations[i].record->alternate &&
                             before.record->atom.residue == locations[i].record->atom.residue;
    if (is_repeated) locations[i].copy = before.copy + 1;
  }
}

}  // namespace

std::size_t keep_one_location(std::vector<AtomRecord>& atoms, std::optional<char> letter) {
  std::vector<Location> locations;
  std::set<std::tuple<Label, Label, Label>> with_letters;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (atoms[i].alternate == ' ') continue;
    locations.push_back(location_of(atoms[i], i));
    with_letters.insert(locations.back().atom_key());
  }
  // One without a letter is another location of an atom that has one with.
  for (std::size_t i = 0; i < atoms.size() && !with_letters.empty(); ++i) {
    if (atoms[i].alternate != ' ') continue;
    const Location location = location_of(atoms[i], i);
    if (with_letters.contains(location.atom_key())) locations.push_back(location);
  }
  std::ranges::stable_sort(locations, {}, [](const Location& location) {
    return std::tuple(location.chain, location.place, location.name, location.record->atom.residue,
                      location.record->alternate);
  });
  std::vector<bool> is_out(atoms.size(), false);
  mark_other_residues(locations, letter, is_out);
  number_copies(locations);
  std::erase_if(locations, [&](const Location& location) { return is_out[location.index]; });
  std::ranges::stable_sort(locations, {}, [](const Location& location) {
    return std::tuple(location.chain, location.place, location.name, location.copy);
  });
  for (std::size_t i = 1, best = 0; i < locations.size(); ++i) {
    if (locations[i].atom_key() != locations[best].atom_key() ||
        locations[i].copy != locations[best].copy) {
      best = i;
    } else if (is_better(*locations[i].record, *locations[best].record, letter)) {
      is_out[locations[std::exchange(best, i)].index] = true;
    } else {
      is_out[locations[i].index] = true;
    }
  }
  std::size_t next = 0;
  return std::erase_if(atoms, [&](const AtomRecord&) { return is_out[next++]; });
}

}  // namespace morskin::skin::molecule_formats
