// PDB: fixed columns, counted from 1 in the comments as in the format's description.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "skin/molecule_formats.h"
#include "skin/radii.h"

namespace morskin::skin::molecule_formats {
namespace {

using geometry::parse_double;
using geometry::TextLines;
using geometry::trimmed;

// Columns first to last of a line; less where the line is shorter.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return line.substr(first - 1, last - first + 1);
}

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::array<std::string_view, 60> standard_residues = {
    "ALA", "ARG", "ASH", "ASN", "ASP", "ASX", "CYM", "CYS", "CYX", "GLH", "GLN", "GLU",
    "GLX", "GLY", "HID", "HIE", "HIP", "HIS", "HSD", "HSE", "HSP", "ILE", "LEU", "LYN",
    "LYS", "MET", "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL", "A",   "C",   "G",
    "I",   "T",   "U",   "DA",  "DC",  "DG",  "DI",  "DT",  "DU",  "ADE", "CYT", "GUA",
    "THY", "URA", "RA",  "RC",  "RG",  "RU",  "DA5", "DC5", "DG5", "DA3", "DC3", "DG3"};

// Whether the residue is one of the standard amino acids or nucleotides.
bool is_standard_residue(std::string_view residue) {
  return std::ranges::find(standard_residues, residue) != standard_residues.end();
}

// The elements of standard residues.
constexpr std::string_view residue_elements = "HDCNOPS";

// Names of four characters leave no column for the blank before an element of one letter, and words
// have no columns; of those that begin with the letters of a heavier element only these, in long
// names before a digit, are taken for it.
constexpr std::array<std::string_view, 8> heavy_in_long_names = {"CL", "BR", "FE", "ZN",
                                                                 "MG", "MN", "SE", "SI"};

std::string_view symbol_or_empty(std::string_view element) {
  return element_symbol(element).value_or(std::string_view());
}

// The element's columns. PDBQT, which passes for PDB, has AutoDock's type one further: "Cl" in
// columns 78-79, or two letters for an element of one, of which "NA" and "OS" are others' symbols.
std::string_view element_field(std::string_view line) {
  const std::string_view type = columns(line, 78, 79);
  const bool is_type = type.size() == 2 && is_letter(type[0]) && is_letter(type[1]);
  if (!is_type || columns(line, 77, 77) != " ") return trimmed(columns(line, 77, 78));
  const bool is_other = type == "NA" || type == "OS" || symbol_or_empty(type).empty();
  return is_other ? type.substr(0, 1) : type;
}

// Those columns, if they have an element that the residue can have; "X" for an unknown one.
std::string_view element_from_columns(std::string_view line, std::string_view residue) {
  const std::string_view field = element_field(line);
  if (field.empty() || !is_letter(field[0])) return {};
  if (field == unknown_element) return unknown_element;
  const std::string_view symbol = symbol_or_empty(field);
  const bool is_usual = residue_elements.find(symbol) != std::string_view::npos;
  return is_usual || !is_standard_residue(residue) ? symbol : std::string_view();
}

// CHARMM's names of ions, of which the first letters are other elements.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> charmm_ions = {{
    {"SOD", "Na"},
    {"POT", "K"},
    {"CLA", "Cl"},
    {"CAL", "Ca"},
    {"CES", "Cs"},
    {"LIT", "Li"},
    {"RUB", "Rb"},
    {"BAR", "Ba"},
    {"CAD", "Cd"},
}};

// Metals of residues that have another name, which CHARMM shifts to column 14 like all short ones.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> metals_in_residues = {
    {{"FE", "HEM"}, {"FE", "HEME"}, {"FE", "FE2"}, {"ZN", "ZN2"}, {"CD", "CD2"}}};

// The element of an ion, which is called like its residue: "ZN" of "ZN", "MG2" of "MG2", "CL" or
// "CL-" of "CL-", "SOD" of "SOD"; or of a metal above. "" if it is none.
std::string_view ion_from_name(std::string_view name, std::string_view residue) {
  const std::pair pair(name, residue);
  if (std::ranges::find(metals_in_residues, pair) != metals_in_residues.end()) {
    return symbol_or_empty(name);
  }
  const std::string_view letters = residue.substr(0, residue.find_first_of("0123456789+-"));
  const bool is_charged = residue.ends_with('+') || residue.ends_with('-');
  if (name != residue && !(is_charged && name == letters)) return {};
  const auto found = std::ranges::find(charmm_ions, residue,
                                       &std::pair<std::string_view, std::string_view>::first);
  return found == charmm_ions.end() ? symbol_or_empty(letters) : found->second;
}

// The element of an atom whose element columns are missing or wrong; "" if unknown. The name is
// that of columns 13-16, untrimmed: an element of one letter starts in the second. In standard
// residues the first letter decides, wherever the name begins.
std::string_view element_from_name(std::string_view name, std::string_view residue) {
  // Some programs shift an ion's name to column 14.
  const std::string_view ion = ion_from_name(trimmed(name), residue);
  if (!ion.empty()) return ion;
  const auto first = std::ranges::find_if(name, is_letter);
  if (first == name.end()) return {};
  const std::string_view from_first(first, name.end());
  const std::string_view one = from_first.substr(0, 1);
  if (is_standard_residue(residue) || first != name.begin()) return symbol_or_empty(one);

  // The name begins in column 13.
  const std::string_view two = name.substr(0, 2);
  const bool is_long = name.size() >= 4 && name[3] != ' ';
  if (name.size() < 2 || !is_letter(name[1])) return symbol_or_empty(one);
  if (is_long) {
    const bool is_heavy = std::ranges::find(heavy_in_long_names, two) != heavy_in_long_names.end();
    if (is_heavy && is_digit(name[2])) return symbol_or_empty(two);
    if (!symbol_or_empty(one).empty()) return symbol_or_empty(one);
  }
  const std::string_view element = symbol_or_empty(two);
  return element.empty() ? symbol_or_empty(one) : element;
}

bool is_atom(std::string_view line) {
  if (line.starts_with("HETATM")) return true;
  return line.starts_with("ATOM") && (line.size() == 4 || !is_letter(line[4]));
}

double take_coordinate(const TextLines& lines, std::size_t first) {
  const std::string_view field = trimmed(columns(lines.line(), first, first + 7));
  const std::optional<double> value = parse_double(field);
  if (!value) {
    lines.fail("no coordinate in columns " + std::to_string(first) + "-" +
               std::to_string(first + 7) + ", found " + geometry::quoted(field) +
               "; PDB columns are fixed, use mmCIF, PQR or XYZR if they overflow");
  }
  return *value;
}

// What is wider than its columns moves all that is behind it. Coordinates that fill theirs still
// read as numbers then, with their first digits from the one before; only the last one's end tells.
void check_not_moved(const TextLines& lines) {
  const std::string_view behind = columns(lines.line(), 55, 60);
  if (behind.empty() || !is_digit(behind[0]) || lines.line()[53] == ' ') return;
  if (parse_double(trimmed(behind)) && behind.find('.') != std::string_view::npos) return;
  lines.fail("no occupancy in columns 55-60, found " + geometry::quoted(trimmed(behind)) +
             "; PDB columns are fixed, use mmCIF, PQR or XYZR if they overflow");
}

// Of "MODEL        2".
std::optional<std::int64_t> number_of_model(std::string_view line) {
  geometry::take_field(line);
  return geometry::parse_integer(geometry::take_field(line));
}

// Column 21 is the fourth letter of a residue's name or, from Phenix, CCP4 and others, the first of
// a chain's. The former never stands behind these names, whose residues have no other forms.
constexpr std::array<std::string_view, 5> names_of_three = {"HOH", "ILE", "LEU", "PHE", "VAL"};

bool has_long_chain_names(std::string_view bytes) {
  TextLines lines(bytes, {});
  while (lines.advance()) {
    const std::string_view line = lines.line(), chain = trimmed(columns(line, 21, 22));
    if (chain.size() < 2 || !is_atom(line)) continue;
    if (std::ranges::find(names_of_three, columns(line, 18, 20)) != names_of_three.end()) {
      return true;
    }
  }
  return false;
}

// @param chain_column  the first, 21 or 22; what is before is the residue's name
AtomRecord atom_on(const TextLines& lines, std::size_t chain_column) {
  const std::string_view line = lines.line();
  AtomRecord record;
  Atom& atom = record.atom;
  const std::string_view name = columns(line, 13, 16);
  atom.name = Label(trimmed(name));
  atom.residue = Label(trimmed(columns(line, 18, chain_column - 1)));
  atom.residue_number = Label(trimmed(columns(line, 23, 27)));
  atom.chain = record.assembly_chain = Label(trimmed(columns(line, chain_column, 22)));
  record.segment = Label(trimmed(columns(line, 73, 76)));
  atom.line = static_cast<std::uint32_t>(lines.number());
  atom.position = {take_coordinate(lines, 31), take_coordinate(lines, 39),
                   take_coordinate(lines, 47)};
  check_not_moved(lines);
  record.is_hetatm = line.starts_with("HETATM");
  record.alternate = line[16];
  record.occupancy = parse_double(trimmed(columns(line, 55, 60))).value_or(1.0);
  std::string_view element = element_from_columns(line, atom.residue.view());
  if (element.empty()) element = element_from_name(name, atom.residue.view());
  atom.element = Label(element);
  return record;
}

}  // namespace

std::string_view element_from_word(std::string_view name, std::string_view residue) {
  // Two letters are one element where the first is none, or in the rest of these: no organic atom's
  // name begins so, with C, N or O and its place behind.
  const std::string_view two = name.substr(0, 2);
  const bool is_heavy = symbol_or_empty(name.substr(0, 1)).empty() ||
                        std::ranges::find(heavy_in_long_names, two) != heavy_in_long_names.end();
  if (is_heavy && !is_standard_residue(residue) && !symbol_or_empty(two).empty()) {
    return symbol_or_empty(two);
  }
  std::string from_column_13(1, ' ');
  from_column_13 += name;
  return element_from_name(from_column_13, residue);
}

ParsedFile parse_records(std::string_view bytes, const std::string& source,
                         const std::string& format, bool (*is_atom)(std::string_view line),
                         AtomRecord (*atom_on)(const TextLines& lines), ModelSearch& models) {
  ParsedFile file;
  file.has_chains = file.has_hetatms = file.has_elements = file.has_locations = true;
  TextLines lines(bytes, source);
  bool is_in_model = false;  // an atom was read since the last model began or ended
  bool is_read = false;      // and its atoms are wanted
  std::optional<std::int64_t> number;
  while (lines.advance()) {
    const std::string_view line = lines.line();
    const std::string_view record = trimmed(columns(line, 1, 6));
    if (is_atom(line)) {
      if (!is_in_model) is_read = models.begin(number);
      is_in_model = true;
      if (is_read) file.atoms.push_back(atom_on(lines));
    } else if (record == "MODEL" || record == "ENDMDL" || record == "END") {
      is_in_model = false;
      number = record == "MODEL" ? number_of_model(line) : std::nullopt;
    }
  }
  if (!models.has_begun()) {
    throw geometry::UnreadableInput(source + ": has no ATOM or HETATM record; is it a " + format +
                                    " file?");
  }
  return file;
}

ParsedFile parse_pdb(std::string_view bytes, const std::string& source, ModelSearch& models) {
  const auto with_letter = [](const TextLines& lines) { return atom_on(lines, 22); };
  const auto with_name = [](const TextLines& lines) { return atom_on(lines, 21); };
  if (has_long_chain_names(bytes)) {
    return parse_records(bytes, source, "PDB", is_atom, with_name, models);
  }
  return parse_records(bytes, source, "PDB", is_atom, with_letter, models);
}

}  // namespace morskin::skin::molecule_formats
