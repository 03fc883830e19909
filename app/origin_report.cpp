#include "app/origin_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/mesh_hashes.h"
#include "app/report_lines.h"
#include "app/selection_arguments.h"
#include "app/stated_skin.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

// The word behind `name ` between the commas of STL's header.
std::optional<std::string> in_brief(const geometry::Provenance& provenance, std::string_view name) {
  const std::string start = ", " + std::string(name) + " ";
  const std::size_t found = provenance.brief.find(start);
  if (found == std::string::npos) return std::nullopt;
  const std::string rest = provenance.brief.substr(found + start.size());
  return rest.substr(0, rest.find(','));
}

/// Whether the hash stated, or its first digits, is the one found.
std::optional<bool> matches(const std::optional<std::string>& stated, const std::string& found) {
  constexpr std::size_t min_digits = 8;  // no fewer are ever written
  if (!stated) return std::nullopt;
  return stated->size() >= min_digits && found.starts_with(*stated);
}

/// All of STL's header: its verdict stands behind what other words are cut to.
std::string quoted_whole(std::string header) {
  std::ranges::replace_if(
      header, [](char c) { return c < 0x20 || c >= 0x7f; }, '?');
  return '"' + header + '"';
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string values(const ordered_json& selection) {
  std::string text;
  for (const auto& [name, value] : selection.items()) {
    // Names of chains may be any bytes.
    text += ", " + name + " " + value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  }
  return text;
}

}  // namespace

void OriginReport::compare_mesh(const geometry::MeshFile& file, unsigned threads) {
  if (stated.is_empty()) return;
  has_curves = file.curved.has_value();
  if (file.is_single_precision) {
    coordinates_match = matches(in_brief(stated, "corners"),
                                hashes_of(file.mesh, Stored::FloatCorners, threads).coordinates);
    return;
  }
  const MeshHashes found = hashes_of(file.mesh, Stored::Doubles, threads);
  coordinates_match = matches(app::stated(stated, "coordinates-sha256"), found.coordinates);
  faces_match = matches(app::stated(stated, "faces-sha256"), found.faces);
}

void OriginReport::compare_input(const std::string& sha256) {
  const bool is_brief = !stated.brief.empty();
  input_matches =
      matches(is_brief ? in_brief(stated, "input") : app::stated(stated, "input-sha256"), sha256);
}

void add_origin(ordered_json& json, const OriginReport& origin) {
  if (origin.stated.is_empty()) return;
  ordered_json result = {{"stated", ordered_json::object()}};
  for (const auto& entry : origin.stated.entries) {
    if (const auto value = stated(origin.stated, entry.key)) result["stated"][entry.key] = *value;
  }
  if (!origin.stated.brief.empty()) result["brief"] = origin.stated.brief;
  result["taken"] = origin.taken;
  result["not_taken"] = origin.not_taken;
  for (const auto& [name, match] : {std::pair("coordinates_match", origin.coordinates_match),
                                    std::pair("faces_match", origin.faces_match),
                                    std::pair("input_matches", origin.input_matches)}) {
    if (match) result[name] = *match;
  }
  json["origin"] = result;
}

std::string origin_text(const OriginReport& origin) {
  if (origin.stated.is_empty()) return "";
  const auto shown = [&](std::string_view key, const std::string& otherwise) {
    const auto value = stated(origin.stated, key);
    return value ? geometry::quoted(*value) : otherwise;
  };
  std::string text;
  if (origin.stated.brief.empty()) {
    text += line("origin", "so the file says: morskin " + shown("version", "?") + ", from " +
                               shown("input", shown("surface", "?")) + ", " +
                               shown("verdict", "no verdict") + "; none of it counts here");
  } else {
    text += line("origin", "so the file says: " + quoted_whole(origin.stated.brief));
  }
  if (!origin.taken.empty()) {
    text += line("taken", joined(origin.taken) +
                              " from the mesh file; options of the command line go first");
  }
  for (const std::string& why : origin.not_taken) text += line("not taken", why);
  std::vector<std::string> same, other;
  for (const auto& [what, match] :
       {std::pair(origin.has_curves ? "coordinates of corners" : "coordinates",
                  origin.coordinates_match),
        std::pair("faces", origin.faces_match), std::pair("input", origin.input_matches)}) {
    if (match) (*match ? same : other).emplace_back(what);
  }
  if (!same.empty()) {
    text += line("unchanged",
                 joined(same) + (origin.stated.brief.empty() ? ", by SHA-256"
                                                             : ", by the first digits of SHA-256"));
  }
  if (!other.empty()) {
    text += line("CHANGED", joined(other) + ": other bytes than when the file was written");
  }
  return text;
}

void add_skin(ordered_json& json, const MoleculeArguments& molecule) {
  add_model(json, molecule);
  const bool drops_all = std::isinf(molecule.drop_voids_below);
  json["drop_voids_below"] = drops_all ? nullptr : ordered_json(molecule.drop_voids_below);
  if (drops_all) json["drop_voids_below_reason"] = "voids of any volume are dropped";
  add_selection(json, molecule.selection);
}

std::string skin_text(const MoleculeArguments& molecule, const certify::Sizing& sizing) {
  ordered_json chosen;
  add_selection(chosen, molecule.selection);
  std::string text = "of " + molecule.input.string() + ": " + model_text(molecule);
  if (molecule.radii) text += ", radii " + *molecule.radii;
  if (chosen.contains("selection")) text += values(chosen["selection"]);
  const double volume = molecule.drop_voids_below;
  text += volume == 0          ? ", voids kept"
          : std::isinf(volume) ? ", voids dropped"
                               : ", voids below " + brief(volume) + " A^3 dropped";
  text += "; C " + brief(sizing.C) + ", Q " + brief(sizing.Q);
  if (std::isfinite(sizing.largest_length_scale)) {
    text += ", edges of " + brief(sizing.edge_length()) + " A";
  }
  return line("skin", text);
}

}  // namespace morskin::app
