#include "app/selection_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "app/model_set.h"
#include "app/skin_arguments.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

// "A,B"; a name is neither empty nor has blanks around it.
std::vector<std::string> parsed_names(std::string_view text, const std::string& option) {
  std::vector<std::string> names;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    const std::string_view name = text.substr(first, comma - first);
    if (name.empty() || geometry::trimmed(name) != name) {
      throw UsageError(option + " takes names with commas between and no blanks, as in A,B");
    }
    names.emplace_back(name);
    first = comma + 1;
  }
  return names;
}

void parse_locations(const std::string& text, skin::Selection& selection) {
  if (text == "likeliest") return;
  if (text == "all") {
    selection.all_locations = true;
  } else if (text.size() == 1 && is_letter_or_digit(text[0])) {
    selection.location = text[0];
  } else {
    throw UsageError("--altloc takes likeliest, all or the letter of a location, as in A");
  }
}

void parse_hetatms(const std::string& text, skin::Selection& selection) {
  if (text == "all") return;
  selection.hetatms.emplace();
  if (text == "none") return;
  *selection.hetatms = parsed_names(text, "--hetatm");
  if (std::ranges::any_of(*selection.hetatms, skin::is_water_residue)) {
    throw UsageError("--hetatm takes no names of water, which --waters keeps");
  }
}

}  // namespace

bool is_set(const TypedSelection& typed) {
  return typed.chains || typed.locations || typed.hydrogens || typed.hetatms ||
         typed.model_number || typed.assembly || typed.waters;
}

void add_selection_options(CLI::App& command, TypedSelection& typed) {
  command
      .add_option("--model-number", typed.model_number,
                  "The model to read: its number, or several: 1,3-5 or all.\n"
                  "Several are for mesh: each writes OUT-3.ply and a report, and the exit code\n"
                  "is the largest")
      ->default_str("the first");
  command
      .add_option("--biological-assembly", typed.assembly,
                  "The copies that make up assembly N, of PDB and mmCIF.\n"
                  "PDB has them in REMARK 350. The copies of chain A are A, A-2, A-3 ...")
      ->default_str("none");
  command
      .add_option("--chain", typed.chains,
                  "Only these chains, A,B,... as the author names them.\n"
                  "_ is the chain without a name")
      ->default_str("all chains");
  command.add_flag("--waters", typed.waters, "Keep the waters, which are left out otherwise");
  command
      .add_option("--hetatm", typed.hetatms,
                  "Of HETATM records keep all, none or residues: NAME,NAME,...\n"
                  "Waters among them go and stay by --waters alone")
      ->default_str("all");
  command
      .add_option("--altloc", typed.locations,
                  "Of alternate locations the likeliest, all or a letter's.\n"
                  "An atom that lacks the letter keeps the likeliest")
      ->default_str("likeliest");
  command.add_option("--hydrogens", typed.hydrogens, "Hydrogen, deuterium too: keep or drop")
      ->check(CLI::IsMember({"keep", "drop"}))
      ->default_str("keep");
}

skin::Selection parsed(const TypedSelection& typed) {
  skin::Selection selection;
  selection.waters = typed.waters;
  selection.hydrogens = typed.hydrogens.value_or("keep") == "keep";
  if (typed.chains) selection.chains = parsed_names(*typed.chains, "--chain");
  if (typed.locations) parse_locations(*typed.locations, selection);
  if (typed.hetatms) parse_hetatms(*typed.hetatms, selection);
  if (typed.model_number) {
    if (ModelSet::parsed(*typed.model_number)) {
      throw UsageError("--model-number: only mesh takes several models; choose one");
    }
    selection.model = parsed_model_number(*typed.model_number);
  }
  if (typed.assembly && typed.assembly->empty()) {
    throw UsageError("--biological-assembly is empty; name one, as in 1");
  }
  selection.assembly = typed.assembly;
  return selection;
}

void add_selection(nlohmann::ordered_json& json, const skin::Selection& selection) {
  nlohmann::ordered_json chosen;
  if (selection.model) chosen["model_number"] = *selection.model;
  if (!selection.chains.empty()) chosen["chain"] = selection.chains;
  if (selection.waters) chosen["waters"] = true;
  if (selection.hetatms) chosen["hetatm"] = *selection.hetatms;
  if (selection.hetatms && selection.hetatms->empty()) chosen["hetatm"] = "none";
  if (selection.all_locations) chosen["altloc"] = "all";
  if (selection.location) chosen["altloc"] = std::string(1, *selection.location);
  if (!selection.hydrogens) chosen["hydrogens"] = "drop";
  if (selection.assembly) chosen["biological_assembly"] = *selection.assembly;
  if (!chosen.empty()) json["selection"] = chosen;
}

}  // namespace morskin::app
