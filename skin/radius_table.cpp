#include "skin/radius_table.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "geometry/error.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/text_lines.h"

namespace morskin::skin {
namespace {

constexpr double largest_radius = 1e6;        // Angstrom, as of molecules' files
constexpr std::size_t max_bytes = 64U << 20;  // far beyond any table of radii

constexpr std::array<std::pair<std::string_view, RadiusSource>, 3> names = {{
    {"elements", RadiusSource::Elements},
    {"bondi", RadiusSource::Bondi},
    {"alvarez", RadiusSource::Alvarez},
}};

/// "C" of "c" and "C"; "ALA:CA" as it is; nothing for what is neither.
std::optional<std::string> normalised(std::string_view key) {
  const std::size_t colon = key.find(':');
  if (colon == std::string_view::npos) {
    const auto element = element_symbol(key);
    return element ? std::optional<std::string>(*element) : std::nullopt;
  }
  const bool is_pair = colon > 0 && colon + 1 < key.size() &&
                       key.find(':', colon + 1) == std::string_view::npos &&
                       key.find_first_of(",=") == std::string_view::npos;
  return is_pair ? std::optional<std::string>(key) : std::nullopt;
}

}  // namespace

std::optional<std::string> RadiusTable::add(std::string_view key, std::string_view radius) {
  const std::optional<std::string> name = normalised(key);
  if (!name) {
    return geometry::quoted(key) +
           " is neither an element nor a residue and an atom as in ALA:CA; correct it";
  }
  const std::optional<double> value = geometry::parse_double(radius);
  if (!value || !(*value > 0 && *value <= largest_radius)) {
    return "the radius of " + *name + " is " + geometry::quoted(radius) +
           ", which is not above 0 and at most 10^6 Angstrom; correct it";
  }
  if (!own_.emplace(*name, *value).second) {
    return *name + " has a radius already; remove one of them";
  }
  return std::nullopt;
}

const std::pair<const std::string, double>* RadiusTable::entry_of(const Atom& atom) const {
  const auto find = [&](const std::string& key) {
    const auto found = own_.find(key);
    return found == own_.end() ? nullptr : &*found;
  };
  const std::string element(atom.element.view());
  const auto* entry = find(std::string(atom.residue.view()) + ":" + std::string(atom.name.view()));
  if (entry == nullptr) entry = find(element);
  if (entry == nullptr && (element == "D" || element == "T")) entry = find("H");
  return entry;
}

std::optional<double> RadiusTable::radius(const Atom& atom) const {
  if (own_.empty()) return van_der_waals_radius(atom.element.view(), source_);
  const auto* entry = entry_of(atom);
  return entry == nullptr ? std::nullopt : std::optional(entry->second);
}

std::string RadiusTable::text_for(std::span<const Atom> atoms) const {
  if (own_.empty()) {
    return std::string(std::ranges::find(names, source_, [](auto& n) { return n.second; })->first);
  }
  std::set<std::pair<std::string, double>> taken;
  for (const Atom& atom : atoms) {
    if (const auto* entry = entry_of(atom)) taken.insert(*entry);
  }
  std::string text;
  for (const auto& [key, radius] : taken) {
    text += (text.empty() ? "" : ",") + key + "=";
    geometry::append_number(text, radius);
  }
  return text;
}

std::vector<std::string> RadiusTable::unused_by(std::span<const Atom> atoms) const {
  std::map<std::string, double, std::less<>> unused = own_;
  for (const Atom& atom : atoms) {
    if (const auto* entry = entry_of(atom)) unused.erase(entry->first);
  }
  std::vector<std::string> names;
  for (const auto& [name, radius] : unused) names.push_back(name);
  return names;
}

std::optional<RadiusTable> parse_radius_table(std::string_view text) {
  for (const auto& [name, source] : names) {
    if (text == name) return RadiusTable(source);
  }
  // What begins like a path is a file, whatever its name holds.
  const auto begins = [&](std::string_view start) { return text.starts_with(start); };
  const bool is_path = begins("/") || begins("./") || begins("../");
  if (is_path || text.find('=') == std::string_view::npos) return std::nullopt;
  RadiusTable table;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    const std::string_view entry = text.substr(first, comma - first);
    const std::size_t equals = std::min(entry.find('='), entry.size());
    const auto wrong =
        table.add(entry.substr(0, equals), entry.substr(std::min(equals + 1, entry.size())));
    if (wrong) throw geometry::RefusedInput("the list of radii: " + *wrong);
    first = comma + 1;
  }
  return table;
}

RadiusTable read_radius_table(const std::filesystem::path& file) {
  const geometry::FileBytes bytes = geometry::read_file(file, max_bytes);
  geometry::TextLines lines(bytes.view(), file.string());
  RadiusTable table;
  bool is_empty = true;
  while (lines.advance()) {
    const std::string_view line = lines.line();
    const auto fields = geometry::fields_of(line.substr(0, line.find('#')));
    if (fields.empty()) continue;
    if (fields.size() != 2) {
      lines.fail("is not an element or RESIDUE:ATOM and a radius; correct it");
    }
    if (const auto wrong = table.add(fields[0], fields[1])) lines.fail(*wrong);
    is_empty = false;
  }
  if (is_empty) throw geometry::UnreadableInput(file.string() + ": has no radius; name another");
  return table;
}

RadiusTable radius_table(const std::string& text) {
  if (const std::optional<RadiusTable> table = parse_radius_table(text)) return *table;
  std::error_code unknown;
  if (!text.empty() && text != "-" && !std::filesystem::exists(text, unknown) && !unknown) {
    throw geometry::UnreadableInput(text +
                                    ": there are no such radii, and no such file; take "
                                    "elements, bondi, alvarez, a list as C=1.7 or a file");
  }
  return read_radius_table(text);
}

}  // namespace morskin::skin
