#include "app/stated_skin.h"

#include <algorithm>
#include <utility>

#include "app/percent_encoding.h"
#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "skin/molecule_files.h"
#include "skin/radius_table.h"

namespace morskin::app {
namespace {

using geometry::Provenance;

std::optional<double> number(const std::string& text) { return geometry::parse_double(text); }

std::optional<std::string> text(const std::string& encoded) { return percent_decoded(encoded); }

std::optional<std::string> model(const std::string& name) {
  return skin::parse_model(name) ? std::optional(name) : std::nullopt;
}

std::optional<std::string> keep_or_drop(const std::string& word) {
  return word == "keep" || word == "drop" ? std::optional(word) : std::nullopt;
}

/// A mesh file may list radii, but not have another file read.
std::optional<std::string> radii(const std::string& encoded) {
  const std::optional<std::string> list = text(encoded);
  try {
    return list && skin::parse_radius_table(*list) ? list : std::nullopt;
  } catch (const geometry::RefusedInput&) {
    return std::nullopt;
  }
}

/// Whether any reader of the file goes by these radii without being asked. A PQR file has radii
/// besides elements, and so may one whose ending tells nothing, as standard input.
bool is_usual(const std::string& radii, const std::filesystem::path& file) {
  const auto format = skin::molecule_format_of(file);
  const bool may_have_radii = !format || *format == skin::MoleculeFormat::Pqr;
  return radii == "input" || radii == "weights" || (radii == "elements" && !may_have_radii);
}

/// Takes statements one by one.
class Completion {
 public:
  Completion(const TypedSkin& given, const Provenance& provenance,
             const std::filesystem::path& molecule)
      : provenance_(provenance), molecule_(molecule), skin_{given, {}, {}} {}

  template <class Option, class Parse>
  void take(std::string_view key, Option& option, const Parse& parse) {
    const auto count = std::ranges::count(provenance_.entries, key, &Provenance::Entry::key);
    if (option || count == 0) return;
    if (count > 1) return refuse(key, "is stated " + std::to_string(count) + " times");
    const std::string value = *stated(provenance_, key);
    option = parse(value);
    if (!option) return refuse(key, geometry::quoted(value) + " is no value of it");
    skin_.taken.emplace_back(key);
  }

  StatedSkin all() {
    TypedSkin& typed = skin_.typed;
    const bool is_size_given = typed.C || typed.Q || typed.size;
    take("model", typed.model, model);
    take("probe", typed.probe, number);
    if (!is_usual(stated(provenance_, "radii").value_or("input"), molecule_)) {
      take("radii", typed.radii, radii);
    }
    take("voids", typed.voids, text);
    take("model-number", typed.selection.model_number, text);
    take("chain", typed.selection.chains, text);
    take("hetatm", typed.selection.hetatms, text);
    take("altloc", typed.selection.locations, text);
    take("hydrogens", typed.selection.hydrogens, keep_or_drop);
    take("biological-assembly", typed.selection.assembly, text);
    std::optional<std::string> waters;
    if (typed.selection.waters) waters = "keep";
    take("waters", waters, keep_or_drop);
    typed.selection.waters = waters == "keep";
    if (!is_size_given) take_sizes(typed);
    if (stated(provenance_, "grow")) refuse("grow", "check knows no skins of grown balls");
    return std::move(skin_);
  }

 private:
  /// All that are stated, or none where one is not to be taken.
  void take_sizes(TypedSkin& typed) {
    const std::size_t taken = skin_.taken.size(), not_taken = skin_.not_taken.size();
    take("C", typed.C, number);
    take("Q", typed.Q, number);
    take("size", typed.size, number);
    if (skin_.not_taken.size() == not_taken) return;
    typed.C.reset();
    typed.Q.reset();
    typed.size.reset();
    for (std::size_t i = taken; i < skin_.taken.size(); ++i) {
      refuse(skin_.taken[i], "C, Q and size are taken together or not at all");
    }
    skin_.taken.resize(taken);
  }

  void refuse(std::string_view key, const std::string& why) {
    skin_.not_taken.push_back(std::string(key) + ": " + why);
  }

  const Provenance& provenance_;
  const std::filesystem::path& molecule_;
  StatedSkin skin_;
};

/// Of the keys that are one choice, and the last to be taken.
bool is_size(std::string_view key) { return key == "C" || key == "Q" || key == "size"; }

/// @throws UsageError, geometry::RefusedInput  for statements that make no sense
StatedMolecule read_with(const std::filesystem::path& file, const TypedSkin& given,
                         const Provenance& provenance) {
  StatedSkin stated = completed(given, provenance, file);
  MoleculeArguments molecule{.input = file};
  certify::Sizing sizing;
  finish(molecule, molecule.input, stated.typed);
  finish(sizing, stated.typed, sizing.C);
  MoleculeInput input = read_input(molecule);
  return {std::move(input), std::move(molecule), sizing, std::move(stated.taken),
          std::move(stated.not_taken)};
}

}  // namespace

std::optional<std::string> stated(const Provenance& provenance, std::string_view key) {
  const auto& entries = provenance.entries;
  if (std::ranges::count(entries, key, &Provenance::Entry::key) != 1) return std::nullopt;
  return std::ranges::find(entries, key, &Provenance::Entry::key)->value;
}

StatedSkin completed(const TypedSkin& given, const Provenance& provenance,
                     const std::filesystem::path& molecule) {
  return Completion(given, provenance, molecule).all();
}

StatedMolecule read_stated(MoleculeArguments molecule, const certify::Sizing& sizing,
                           const TypedSkin& given, const Provenance& provenance) {
  StatedSkin all = completed(given, provenance, molecule.input);
  if (!all.taken.empty()) {
    try {
      return read_with(molecule.input, given, provenance);
    } catch (const UsageError&) {  // one by one, then, to find what makes no sense
    } catch (const geometry::RefusedInput&) {
    }
  }
  Provenance kept;
  for (std::size_t i = 0; i < all.taken.size();) {
    const Provenance before = kept;
    std::string keys;
    do {
      keys += (keys.empty() ? "" : ", ") + all.taken[i];
      kept.entries.push_back({all.taken[i], *stated(provenance, all.taken[i])});
    } while (++i < all.taken.size() && is_size(all.taken[i - 1]));
    const auto refuse = [&](const std::exception& error) {
      kept = before;
      all.not_taken.push_back(keys + ": " + error.what());
    };
    try {
      read_with(molecule.input, given, kept);
    } catch (const UsageError& error) {
      refuse(error);
    } catch (const geometry::RefusedInput& error) {
      refuse(error);
    }
  }
  if (!kept.entries.empty()) {
    StatedMolecule result = read_with(molecule.input, given, kept);
    result.not_taken = std::move(all.not_taken);
    return result;
  }
  MoleculeInput input = read_input(molecule);
  return {std::move(input), std::move(molecule), sizing, {}, std::move(all.not_taken)};
}

}  // namespace morskin::app
