// Alternate places: the same atom at several positions, told apart by a letter.

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "skin/molecule_formats.h"

namespace morskin::skin::molecule_formats {
namespace {

// One place of an atom that has several.
struct Place {
  std::size_t index;  // in the file
  Label chain;
  Label residue_number;
  Label name;        // deuterium as hydrogen: where H and D share a site, it is one atom
  std::size_t copy;  // files made by symmetry may repeat chain, number and letter
  const AtomRecord* record;

  auto residue_key() const { return std::tie(chain, residue_number); }
  auto atom_key() const { return std::tie(chain, residue_number, name); }
};

bool is_likelier(const AtomRecord& a, const AtomRecord& b) {
  if (a.occupancy != b.occupancy) return a.occupancy > b.occupancy;
  return a.alternate < b.alternate;
}

Place place_of(const AtomRecord& record, std::size_t index) {
  std::string name(record.atom.name.view());
  const std::size_t letter = name.find_first_not_of("0123456789");
  if (record.atom.element.view() == "D" && letter != std::string::npos && name[letter] == 'D') {
    name[letter] = 'H';
  }
  return {index, record.atom.chain, record.atom.residue_number, Label(name), 0, &record};
}

// Marks the places of other identities than the residue's likeliest.
void mark_unlikely_residues(const std::vector<Place>& places, std::vector<bool>& is_out) {
  for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
    const Place* likeliest = &places[first];
    for (last = first; last < places.size(); ++last) {
      if (places[last].residue_key() != places[first].residue_key()) break;
      if (is_likelier(*places[last].record, *likeliest->record)) likeliest = &places[last];
    }
    for (std::size_t i = first; i < last; ++i) {
      if (places[i].record->atom.residue != likeliest->record->atom.residue) {
        is_out[places[i].index] = true;
      }
    }
  }
}

// Counts the places that repeat their atom and letter.
void number_copies(std::vector<Place>& places) {
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Place& before = places[i - 1];
    const bool is_repeated = before.atom_key() == places[i].atom_key() &&
                             before.record->alternate == places[i].record->alternate &&
                             before.record->atom.residue == places[i].record->atom.residue;
    if (is_repeated) places[i].copy = before.copy + 1;
  }
}

}  // namespace

std::size_t keep_likeliest_places(std::vector<AtomRecord>& atoms) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (atoms[i].alternate != ' ') places.push_back(place_of(atoms[i], i));
  }
  std::ranges::stable_sort(places, {}, [](const Place& place) {
    return std::tuple(place.chain, place.residue_number, place.name, place.record->atom.residue,
                      place.record->alternate);
  });
  std::vector<bool> is_out(atoms.size(), false);
  mark_unlikely_residues(places, is_out);
  number_copies(places);
  std::erase_if(places, [&](const Place& place) { return is_out[place.index]; });
  std::ranges::stable_sort(places, {}, [](const Place& place) {
    return std::tuple(place.chain, place.residue_number, place.name, place.copy);
  });
  for (std::size_t i = 1, best = 0; i < places.size(); ++i) {
    if (places[i].atom_key() != places[best].atom_key() || places[i].copy != places[best].copy) {
      best = i;
    } else if (is_likelier(*places[i].record, *places[best].record)) {
      is_out[places[std::exchange(best, i)].index] = true;
    } else {
      is_out[places[i].index] = true;
    }
  }
  std::size_t next = 0;
  return std::erase_if(atoms, [&](const AtomRecord&) { return is_out[next++]; });
}

}  // namespace morskin::skin::molecule_formats
