#include "skin/selection.h"

#include <algorithm>
#include <array>
#include <set>

#include "geometry/error.h"
#include "skin/molecule_formats.h"
#include "skin/radii.h"

namespace morskin::skin {
namespace {

using geometry::RefusedInput;
using molecule_formats::AtomRecord;
using molecule_formats::ParsedFile;

constexpr std::array<std::string_view, 15> water_residues = {"HOH", "DOD", "WAT",  "H2O",  "D2O",
                                                             "SOL", "SPC", "TIP",  "TP3",  "TP4",
                                                             "TP5", "T3P", "TIP3", "TIP4", "TIP5"};

bool is_water(const AtomRecord& record) { return is_water_residue(record.atom.residue.view()); }

bool is_hydrogen(const AtomRecord& record) {
  const std::string_view element = record.atom.element.view();
  return element == "H" || element == "D" || element == "T";
}

Label chain_of(const AtomRecord& record) {
  return record.atom.chain.is_empty() ? Label("_") : record.atom.chain;
}

// Cut as the file's names are.
std::set<Label> labels_of(const std::vector<std::string>& names) {
  std::set<Label> labels;
  for (const std::string& name : names) labels.insert(Label(name));
  return labels;
}

std::string_view text_of(const Label& name) { return name.view(); }
std::string_view text_of(const std::string& name) { return name; }

template <class Name>
std::string listed(const std::set<Name>& names) {
  constexpr std::size_t max_names = 60;
  std::string text;
  std::size_t count = 0;
  for (const Name& name : names) {
    if (++count > max_names) break;
    const std::string_view shown = text_of(name);
    text += (text.empty() ? "" : ", ") + (shown.empty() ? "\"\"" : std::string(shown));
  }
  if (count > max_names) text += " and " + std::to_string(names.size() - max_names) + " more";
  return text;
}

// A name that the file does not have is a slip more often than a wish.
void require_all(const std::vector<std::string>& chosen, const std::set<Label>& present,
                 const ParsedFile& file, const std::string& what, const std::string& source) {
  std::set<std::string> missing;
  for (const std::string& name : chosen) {
    const bool is_other = name.size() > Label::max_size && !file.long_names.contains(name);
    if (is_other || !present.contains(Label(name))) missing.insert(name);
  }
  if (missing.empty()) return;
  throw RefusedInput(source + ": has no " + what + " " + listed(missing) + "; " +
                     (present.empty() ? "leave the name out" : "choose from " + listed(present)));
}

// MW of SOL, EPW of WAT: models of water have sites that are no atoms.
std::size_t leave_out_sites_of_water(ParsedFile& file) {
  if (file.has_radii || file.has_weights) return 0;
  return std::erase_if(file.atoms, [](const AtomRecord& record) {
    return is_water(record) && !element_symbol(record.atom.element.view());
  });
}

// Leaves atoms out for one reason after the other, but never the last.
class Selector {
 public:
  Selector(ParsedFile& file, const Selection& selection, const std::string& source)
      : file_(file), atoms_(file.atoms), selection_(selection), source_(source) {}

  std::size_t leave_out_other_chains() {
    if (selection_.chains.empty()) return 0;
    std::set<Label> present;
    for (const AtomRecord& record : atoms_) present.insert(chain_of(record));
    const std::set<Label> chosen = labels_of(selection_.chains);
    require_all(selection_.chains, present, file_, "chain", source_);
    return leave_out("the other chains",
                     [&](const AtomRecord& record) { return !chosen.contains(chain_of(record)); });
  }

  std::size_t leave_out_waters() { return leave_out("water", is_water); }

  std::size_t leave_out_hetatms(const std::set<Label>& present) {
    if (!selection_.hetatms) return 0;
    const std::set<Label> chosen = labels_of(*selection_.hetatms);
    require_all(*selection_.hetatms, present, file_, "HETATM record of a residue", source_);
    return leave_out("the HETATM records", [&](const AtomRecord& record) {
      return record.is_hetatm && !is_water(record) && !chosen.contains(record.atom.residue);
    });
  }

  std::size_t leave_out_hydrogens() {
    return selection_.hydrogens ? 0 : leave_out("hydrogen", is_hydrogen);
  }

 private:
  template <class IsOut>
  std::size_t leave_out(const std::string& what, IsOut is_out) {
    const std::size_t count = std::erase_if(atoms_, is_out);
    if (count == 0 || !atoms_.empty()) return count;
    const std::string chains =
        selection_.chains.empty() ? "" : " of chain " + listed(labels_of(selection_.chains));
    throw RefusedInput(source_ + ": no atom" + chains + " is left without " + what +
                       "; leave less out");
  }

  const ParsedFile& file_;
  std::vector<AtomRecord>& atoms_;
  const Selection& selection_;
  const std::string& source_;
};

// Atoms cannot be chosen by what their file does not tell.
void check_format(const ParsedFile& file, const Selection& selection, const std::string& source) {
  const auto require = [&](bool is_told, bool is_asked, const std::string& what) {
    if (is_told || !is_asked) return;
    throw RefusedInput(source + ": does not tell " + what + "; do not choose by it");
  };
  require(file.has_chains, !selection.chains.empty(), "an atom's chain");
  require(file.has_hetatms, selection.hetatms.has_value(), "which atoms have a HETATM record");
  require(file.has_elements, !selection.hydrogens, "which atoms are hydrogen");
  require(file.has_locations, selection.all_locations || selection.location.has_value(),
          "an atom's alternate locations");
}

}  // namespace

bool is_water_residue(std::string_view residue) {
  return std::ranges::find(water_residues, residue) != water_residues.end();
}

std::string listed_models(std::vector<std::int64_t> numbers) {
  constexpr std::size_t max_runs = 20;
  std::ranges::sort(numbers);
  const auto gap_before = [&](std::size_t place) {  // never negative, but perhaps beyond 2^63
    return static_cast<std::uint64_t>(numbers[place]) -
           static_cast<std::uint64_t>(numbers[place - 1]);
  };
  std::string text;
  std::size_t runs = 0;
  for (std::size_t first = 0, last = 0; first < numbers.size(); first = last + 1) {
    last = first;
    while (last + 1 < numbers.size() && gap_before(last + 1) <= 1) ++last;
    if (++runs > max_runs) return text + " ...";
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[first]);
    if (numbers[last] == numbers[first]) continue;
    text += last == first + 1 ? ", " : " to ";
    text += std::to_string(numbers[last]);
  }
  return text;
}

namespace molecule_formats {

bool ModelSearch::begin(std::optional<std::int64_t> number) {
  const std::int64_t known = number.value_or(static_cast<std::int64_t>(numbers_.size() + 1));
  numbers_.push_back(known);
  if (is_found_ || (wanted_ && *wanted_ != known)) return false;
  is_found_ = true;
  return true;
}

std::size_t ModelSearch::others(const std::string& source) const {
  if (is_found_ || numbers_.empty()) return numbers_.size() - (is_found_ ? 1 : 0) + passed_over_;
  const auto [least, most] = std::ranges::minmax(numbers_);
  throw RefusedInput(
      source + ": has no model " + std::to_string(*wanted_) + "; " +
      (least == most ? "its only one is number " + std::to_string(least)
                     : "choose from " + listed_models(numbers_)) +
      (passed_over_ > 0 ? "; those of later data blocks cannot be read: make a file of each" : ""));
}

std::vector<std::int64_t> ModelSearch::numbers(const std::string& source) const {
  if (passed_over_ > 0) {
    throw RefusedInput(source + ": its models are in several data blocks; make a file of each");
  }
  std::set<std::int64_t> seen;
  for (const std::int64_t number : numbers_) {
    if (seen.insert(number).second) continue;
    throw RefusedInput(source + ": two of its models have the number " + std::to_string(number) +
                       "; renumber one");
  }
  return numbers_;
}

ReadingCounts keep_selected(ParsedFile& file, const Selection& selection,
                            const std::string& source) {
  check_format(file, selection, source);
  ReadingCounts counts;
  counts.unknown = std::erase_if(file.atoms, [](const AtomRecord& record) {
    return record.atom.element.view() == unknown_element;
  });
  const bool has_others = std::ranges::any_of(file.atoms, [&](const AtomRecord& record) {
    return !is_water(record) && !(file.has_radii && record.atom.radius == 0);
  });
  std::set<Label> hetatms;
  if (selection.hetatms) {
    for (const AtomRecord& record : file.atoms) {
      if (record.is_hetatm && !is_water(record)) hetatms.insert(record.atom.residue);
    }
  }
  Selector selector(file, selection, source);
  counts.other_chains = selector.leave_out_other_chains();
  if (!selection.waters && has_others) counts.waters = selector.leave_out_waters();
  counts.unknown += leave_out_sites_of_water(file);
  counts.hetatms = selector.leave_out_hetatms(hetatms);
  if (!selection.all_locations) {
    counts.alternates = keep_one_location(file.atoms, selection.location);
  }
  counts.at_location =
      static_cast<std::size_t>(std::ranges::count_if(file.atoms, [&](const AtomRecord& record) {
        return record.alternate == selection.location;
      }));
  counts.hydrogens = selector.leave_out_hydrogens();
  return counts;
}

}  // namespace molecule_formats
}  // namespace morskin::skin
