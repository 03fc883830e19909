// PQR, XYZ, XYZR and XYZW: words separated by white space.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "skin/molecule_formats.h"
#include "skin/radii.h"

namespace morskin::skin::molecule_formats {
namespace {

using geometry::fields_of;
using geometry::parse_double;
using geometry::parse_integer;
using geometry::quoted;
using geometry::take_field;
using geometry::TextLines;
using geometry::trimmed;

double number_in(std::string_view field, std::string_view what, const TextLines& lines) {
  const std::optional<double> value = parse_double(field);
  if (!value) {
    const std::string found = field.empty() ? "the end of the line" : quoted(field);
    lines.fail("expected " + std::string(what) + ", found " + found + "; mend the line");
  }
  return *value;
}

std::uint32_t line_number(const TextLines& lines) {
  return static_cast<std::uint32_t>(lines.number());
}

/// A label would cut what is longer, and two atoms, residues or chains could become one.
/// @param what  the field, of the atom called `name`
Label whole_label(std::string_view field, std::string_view what, std::string_view name,
                  const TextLines& lines) {
  if (field.size() <= Label::max_size) return Label(field);
  throw geometry::RefusedInput(lines.location() + ": atom " + quoted(name) + " has the " +
                               std::string(what) + " " + quoted(field) + ", longer than " +
                               std::to_string(Label::max_size) + " letters; shorten it");
}

// record serial name residue [chain] number x y z charge radius; the serial may stick to the
// record, and a number of four digits to the chain's letter.
AtomRecord pqr_atom(const TextLines& lines) {
  std::vector<std::string_view> fields = fields_of(lines.line());
  const std::size_t record_size = fields[0].starts_with("ATOM") ? 4 : 6;
  if (fields[0].size() > record_size) {
    const std::string_view serial = fields[0].substr(record_size);
    fields[0] = fields[0].substr(0, record_size);
    fields.insert(fields.begin() + 1, serial);
  }
  const bool has_letter = fields.size() == 10 && fields[4].size() > 1 &&
                          std::string_view("-0123456789").find(fields[4][0]) == std::string::npos;
  if (has_letter) {
    const std::string_view number = fields[4].substr(1);
    fields[4] = fields[4].substr(0, 1);
    fields.insert(fields.begin() + 5, number);
  }
  if (fields.size() < 10 || fields.size() > 11) {
    lines.fail(
        "expected 10 or 11 fields (record, serial, name, residue, chain if any, number, "
        "x, y, z, charge, radius), found " +
        std::to_string(fields.size()) + "; separate them with blanks");
  }
  const std::size_t x = fields.size() - 5;
  AtomRecord record;
  Atom& atom = record.atom;
  atom.line = line_number(lines);
  const std::string_view name = fields[2];
  atom.name = whole_label(name, "name", name, lines);
  atom.residue = whole_label(fields[3], "residue", name, lines);
  if (fields.size() == 11) atom.chain = whole_label(fields[4], "chain", name, lines);
  // A column more than there should be would move all that comes behind it.
  if (fields[x - 1].find('.') != std::string_view::npos) {
    lines.fail("expected the residue's number, found " + quoted(fields[x - 1]) + "; mend the line");
  }
  atom.residue_number = whole_label(fields[x - 1], "residue number", name, lines);
  atom.element = Label(element_from_word(name, fields[3]));
  atom.position = {number_in(fields[x], "the coordinate x", lines),
                   number_in(fields[x + 1], "the coordinate y", lines),
                   number_in(fields[x + 2], "the coordinate z", lines)};
  record.is_hetatm = fields[0].starts_with("HETATM");
  record.charge = number_in(fields[x + 3], "the charge", lines);
  atom.radius = number_in(fields[x + 4], "the radius", lines);
  return record;
}

// "C", "cl", "17"; a number behind the letters ("C12") only distinguishes atoms of an element.
Label xyz_element(std::string_view field, const TextLines& lines) {
  std::optional<std::string_view> element;
  if (const auto atomic_number = parse_integer(field)) {
    element = element_symbol(static_cast<long long>(*atomic_number));
  } else {
    element = element_symbol(field.substr(0, field.find_first_of("0123456789")));
  }
  if (!element) lines.fail(quoted(field) + " is no element; write its symbol or atomic number");
  return Label(*element);
}

/// Where a row of XYZ has the element and the first of three coordinates, counted from 0.
struct XyzColumns {
  std::size_t element = 0, x = 1;
};

/// The value of Properties in the comment of an extended XYZ file; empty if it has none.
std::string_view properties_in(std::string_view comment) {
  constexpr std::string_view key = "Properties=";
  for (std::string_view word : fields_of(comment)) {
    if (!word.starts_with(key)) continue;
    word.remove_prefix(key.size());
    return word.starts_with('"') ? word.substr(1, word.find('"', 1) - 1) : word;
  }
  return {};
}

/// Up to the next colon, which is taken too.
std::string_view take_part(std::string_view& rest) {
  const std::size_t colon = std::min(rest.find(':'), rest.size());
  const std::string_view part = rest.substr(0, colon);
  rest.remove_prefix(std::min(colon + 1, rest.size()));
  return part;
}

// Of "species:S:1:pos:R:3", the name, type and width of one column after the other. What is not of
// this form is a comment like any other.
XyzColumns xyz_columns(const TextLines& lines) {
  constexpr std::int64_t widest = 1000;
  constexpr std::size_t none = std::string_view::npos;
  std::size_t symbol = none, atomic_number = none, x = none;
  std::string_view rest = properties_in(lines.line());
  if (rest.empty()) return {};
  for (std::size_t column = 0; !rest.empty();) {
    const std::string_view name = take_part(rest);
    const bool has_type = !take_part(rest).empty();
    const std::optional<std::int64_t> width = parse_integer(take_part(rest));
    if (name.empty() || !has_type || !width || *width < 1 || *width > widest) return {};
    if (name == "species" && *width == 1) symbol = column;
    if (name == "Z" && *width == 1) atomic_number = column;
    if (name == "pos" && *width == 3) x = column;
    column += static_cast<std::size_t>(*width);
  }
  const std::size_t element = symbol != none ? symbol : atomic_number;
  if (element != none && x != none) return {element, x};
  lines.fail("Properties names no column " +
             std::string(x == none ? "pos:R:3" : "species:S:1 or Z:I:1") + "; mend the comment");
}

AtomRecord xyz_atom(const TextLines& lines, const XyzColumns& columns) {
  const std::vector<std::string_view> fields = fields_of(lines.line());
  const auto field = [&](std::size_t column) {
    return column < fields.size() ? fields[column] : std::string_view();
  };
  AtomRecord record;
  record.atom.line = line_number(lines);
  record.atom.element = xyz_element(field(columns.element), lines);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    record.atom.position[static_cast<Eigen::Index>(axis)] =
        number_in(field(columns.x + axis), "a coordinate", lines);
  }
  return record;
}

/// The numbers of a line, of which there must be four; nothing for a line of comment.
std::optional<std::array<double, 4>> four_numbers(const TextLines& lines, std::string_view what) {
  std::string_view fields = lines.line().substr(0, lines.line().find('#'));
  std::string_view field = take_field(fields);
  if (field.empty()) return std::nullopt;
  std::array<double, 4> numbers;
  for (double& number : numbers) {
    number = number_in(field, what, lines);
    field = take_field(fields);
  }
  return numbers;
}

Atom ball(const std::array<double, 4>& row, double radius, const TextLines& lines) {
  Atom atom;
  atom.position = {row[0], row[1], row[2]};
  atom.radius = radius;
  atom.line = line_number(lines);
  return atom;
}

}  // namespace

bool is_pqr_record(std::string_view word) {
  for (const std::string_view record : {"ATOM", "HETATM"}) {
    if (word.starts_with(record)) {
      const std::string_view rest = word.substr(record.size());
      return rest.empty() || record == "HETATM" || parse_integer(rest).has_value();
    }
  }
  return false;
}

ParsedFile parse_pqr(std::string_view bytes, const std::string& source, ModelSearch& models) {
  const auto is_atom = [](std::string_view line) { return is_pqr_record(take_field(line)); };
  ParsedFile file = parse_records(bytes, source, "PQR", is_atom, pqr_atom, models);
  file.has_locations = false;
  file.has_radii = true;
  file.has_charges = true;
  return file;
}

ParsedFile parse_xyz(std::string_view bytes, const std::string& source, ModelSearch& models) {
  ParsedFile file;
  file.has_elements = true;
  TextLines lines(bytes, source);
  while (lines.advance()) {
    const std::string_view line = trimmed(lines.line());
    if (line.empty()) continue;
    std::string_view fields = line;
    const std::optional<std::int64_t> count = parse_integer(take_field(fields));
    if (!count || *count < 0 || !trimmed(fields).empty()) {
      lines.fail(
          "expected the number of atoms, found " + quoted(line) +
          (models.has_begun() ? "; the count above may be too small" : "; is it an XYZ file?"));
    }
    const bool is_read = models.begin();
    const bool has_comment = lines.advance();
    const XyzColumns columns = has_comment && is_read ? xyz_columns(lines) : XyzColumns();
    for (std::int64_t atom = 0; atom < *count; ++atom) {
      if (!lines.advance() || trimmed(lines.line()).empty()) {
        lines.fail("the atoms end after " + std::to_string(atom) + " of " + std::to_string(*count) +
                   " announced; mend the count");
      }
      if (is_read) file.atoms.push_back(xyz_atom(lines, columns));
    }
  }
  return file;
}

ParsedFile parse_xyzr(std::string_view bytes, const std::string& source, ModelSearch& models) {
  ParsedFile file;
  file.has_radii = true;
  models.begin();
  TextLines lines(bytes, source);
  while (lines.advance()) {
    if (trimmed(lines.line()) == weights_line) {
      lines.fail("the fourth numbers are weights, not radii; end the file's name with .xyzw");
    }
    if (const auto row = four_numbers(lines, "x y z r")) {
      file.atoms.push_back({.atom = ball(*row, (*row)[3], lines)});
    }
  }
  return file;
}

ParsedFile parse_xyzw(std::string_view bytes, const std::string& source, ModelSearch& models) {
  ParsedFile file;
  file.has_weights = true;
  models.begin();
  TextLines lines(bytes, source);
  while (lines.advance()) {
    if (const auto row = four_numbers(lines, "x y z w")) {
      file.atoms.push_back({.atom = ball(*row, 0, lines), .weight = (*row)[3]});
    }
  }
  return file;
}

}  // namespace morskin::skin::molecule_formats
