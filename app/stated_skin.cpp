#include "app/stated_skin.h"

#include <algorithm>
#include <utility>

#include "app/percent_encoding.h"
#include "geometry/error.h"
#include "geometry/files/text_lines.h"
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

/// What a reader does without being asked.
bool is_usual(const std::string& radii) {
  return radii == "input" || radii == "weights" || radii == "elements";
}

/// Takes statements one by one.
class Completion {
 public:
  Completion(const TypedSkin& given, const Provenance& provenance)
      : provenance_(provenance), skin_{given, {}, {}} {}

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
    if (!is_usual(stated(provenance_, "radii").value_or("input"))) {
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
    if (!is_size_given) {
      take("C", typed.C, number);
      take("Q", typed.Q, number);
      take("size", typed.size, number);
    }
    if (stated(provenance_, "grow")) refuse("grow", "check knows no skins of grown balls");
    return std::move(skin_);
  }

 private:
  void refuse(std::string_view key, const std::string& why) {
    skin_.not_taken.push_back(std::string(key) + ": " + why);
  }

  const Provenance& provenance_;
  StatedSkin skin_;
};

}  // namespace

std::optional<std::string> stated(const Provenance& provenance, std::string_view key) {
  const auto& entries = provenance.entries;
  if (std::ranges::count(entries, key, &Provenance::Entry::key) != 1) return std::nullopt;
  return std::ranges::find(entries, key, &Provenance::Entry::key)->value;
}

StatedSkin completed(const TypedSkin& given, const Provenance& provenance) {
  return Completion(given, provenance).all();
}

StatedMolecule read_stated(MoleculeArguments molecule, const certify::Sizing& sizing,
                           const TypedSkin& given, const Provenance& provenance) {
  StatedSkin stated = completed(given, provenance);
  if (!stated.taken.empty()) {
    try {
      MoleculeArguments by_file{.input = molecule.input};
      certify::Sizing its_sizing;
      finish(by_file, by_file.input, stated.typed);
      finish(its_sizing, stated.typed, its_sizing.C);
      MoleculeInput input = read_input(by_file);
      return {std::move(input), std::move(by_file), its_sizing, std::move(stated.taken),
              std::move(stated.not_taken)};
    } catch (const UsageError& error) {
      stated.not_taken.emplace_back(error.what());
    } catch (const geometry::RefusedInput& error) {
      stated.not_taken.emplace_back(error.what());
    }
  }
  MoleculeInput input = read_input(molecule);
  return {std::move(input), std::move(molecule), sizing, {}, std::move(stated.not_taken)};
}

}  // namespace morskin::app
