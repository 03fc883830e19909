// mmCIF: gemmi parses the grammar. The table of atoms is read here, because few of its columns are
// needed and small files lack some that gemmi's own reader requires.

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <gemmi/cif.hpp>
#include <gemmi/numb.hpp>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "skin/assembly.h"
#include "skin/molecule_formats.h"
#include "skin/radii.h"

namespace morskin::skin::molecule_formats {
namespace {

namespace cif = gemmi::cif;

// Tags of _atom_site, in the order of Column; a row without a value of one has the other.
enum Column : std::size_t {
  Record,
  X,
  Y,
  Z,
  Symbol,
  Name,
  Residue,
  Number,
  Insertion,
  Chain,
  AssemblyChain,
  Alternate,
  Occupancy,
  ModelNumber,
  ColumnCount
};
struct ColumnTags {
  std::string_view tag, other = {};
};
constexpr std::array<ColumnTags, ColumnCount> column_tags = {{
    {"group_PDB"},
    {"Cartn_x"},
    {"Cartn_y"},
    {"Cartn_z"},
    {"type_symbol"},
    {"auth_atom_id", "label_atom_id"},
    {"auth_comp_id", "label_comp_id"},
    {"auth_seq_id", "label_seq_id"},
    {"pdbx_PDB_ins_code"},
    {"auth_asym_id", "label_asym_id"},
    {"label_asym_id", "auth_asym_id"},
    {"label_alt_id"},
    {"occupancy"},
    {"pdbx_PDB_model_num"},
}};

cif::Document parse_document(std::string_view bytes, const std::string& source) {
  try {
    return cif::read_memory(bytes.data(), bytes.size(), source.c_str());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    // gemmi's text begins with the source and the line.
    throw geometry::UnreadableInput(std::string(error.what()) + "; is it an mmCIF file?");
  }
}

// The rows of the atom table, of which each holds one value per tag.
class AtomTable {
 public:
  explicit AtomTable(cif::Block& block) {
    for (cif::Item& item : block.items) {
      if (item.type == cif::ItemType::Pair) take_of_only_row(item.pair);
      if (item.type != cif::ItemType::Loop) continue;
      if (!item.loop.tags.empty() && gemmi::istarts_with(item.loop.tags[0], "_atom_site.")) {
        loop_ = &item.loop;
        loop_line_ = static_cast<std::size_t>(item.line_number);
      }
    }
    if (loop_ == nullptr && !only_row_.tags.empty()) loop_ = &only_row_;
    if (loop_ == nullptr) return;
    for (std::size_t column = 0; column < ColumnCount; ++column) {
      columns_[column] = {column_of(column_tags[column].tag), column_of(column_tags[column].other)};
    }
  }

  bool has_atoms() const { return loop_ != nullptr && size() > 0; }
  bool has(Column column) const { return std::ranges::max(columns_[column]) >= 0; }
  std::size_t size() const { return loop_->length(); }

  // The value without its quotation marks; empty if the column is missing or the value unknown.
  std::string value(std::size_t row, Column column) const {
    for (const int place : columns_[column]) {
      if (place >= 0 && !cif::is_null(at(row, place))) return cif::as_string(at(row, place));
      if (column == Chain && place >= 0) break;  // an atom without an author's chain is of none
    }
    return {};
  }
  const std::string& raw(std::size_t row, Column of) const { return at(row, columns_[of][0]); }
  // gemmi does not keep the lines of values. If, as usual, each row has its own line, the first
  // row's line gives the others; otherwise they stay unknown. All text before is gone through.
  void find_lines(std::string_view text) {
    geometry::TextLines lines(text, {});
    std::size_t row = 0;
    while (loop_ != &only_row_ && row < loop_->length() && lines.advance()) {
      if (lines.number() < loop_line_) continue;
      std::string_view fields = lines.line();
      const std::string_view first = geometry::take_field(fields);
      if (row == 0 && (first.empty() || first[0] == '#' || first == "loop_" || first[0] == '_')) {
        continue;
      }
      if (row == 0) first_line_ = lines.number();
      if (first != at(row, 0)) break;
      ++row;
    }
    if (row < loop_->length()) first_line_ = 0;
  }
  std::uint32_t line_of(std::size_t row) const {
    return first_line_ == 0 ? 0 : static_cast<std::uint32_t>(first_line_ + row);
  }

 private:
  // A table of one row may be written as tags with their values.
  void take_of_only_row(const cif::Pair& pair) {
    if (!gemmi::istarts_with(pair[0], "_atom_site.")) return;
    only_row_.tags.push_back(pair[0]);
    only_row_.values.push_back(pair[1]);
  }

  int column_of(std::string_view tag) const {
    return tag.empty() ? -1 : loop_->find_tag("_atom_site." + std::string(tag));
  }
  const std::string& at(std::size_t row, int place) const {
    return loop_->values[row * loop_->tags.size() + static_cast<std::size_t>(place)];
  }

  cif::Loop* loop_ = nullptr;
  cif::Loop only_row_;
  std::array<std::array<int, 2>, ColumnCount> columns_{};  // of both tags; -1 if missing
  std::size_t loop_line_ = 0;                              // of the loop, which the rows come after
  std::size_t first_line_ = 0;                             // of the first row; 0 if unknown
};

double coordinate(const AtomTable& table, std::size_t row, Column column,
                  const std::string& source) {
  const double value = cif::as_number(table.raw(row, column));
  if (value == value) return value;
  const std::uint32_t line = table.line_of(row);
  throw geometry::UnreadableInput(source + (line > 0 ? ":" + std::to_string(line) : "") +
                                  ": atom " + std::to_string(row + 1) + " has coordinate " +
                                  geometry::quoted(table.raw(row, column)) +
                                  ", which is no number; remove the atom");
}

// The element of "C", "CL", "N1+"; where the symbol is missing, that of the atom's name.
Label element_of(const std::string& symbol, const std::string& name, std::string_view residue) {
  const std::size_t letters =
      symbol.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
  if (!symbol.empty()) {
    const auto element = element_symbol(std::string_view(symbol).substr(0, letters));
    return Label(element.value_or(symbol));
  }
  return Label(element_from_word(name, residue));
}

/// Labels of names that may be longer than these. What they tell apart must stay so.
class Names {
 public:
  explicit Names(const std::string& source) : source_(source) {}

  Label label(const std::string& name) {
    const Label cut(name);
    if (name.size() < Label::max_size) return cut;
    const auto [place, is_new] = whole_.try_emplace(cut, name);
    if (!is_new && place->second != name) {
      throw geometry::RefusedInput(source_ + ": the names " + geometry::quoted(name) + " and " +
                                   geometry::quoted(place->second) + " differ only behind their " +
                                   std::to_string(cut.view().size()) + "th character; rename one");
    }
    return cut;
  }

  std::set<std::string> long_names() const {
    std::set<std::string> names;
    for (const auto& [cut, name] : whole_) {
      if (name.size() > Label::max_size) names.insert(name);
    }
    return names;
  }

 private:
  const std::string& source_;
  std::map<Label, std::string> whole_;
};

AtomRecord atom_in(const AtomTable& table, std::size_t row, const std::string& source,
                   Names& names) {
  AtomRecord record;
  Atom& atom = record.atom;
  const std::string name = table.value(row, Name);
  atom.line = table.line_of(row);
  atom.position = {coordinate(table, row, X, source), coordinate(table, row, Y, source),
                   coordinate(table, row, Z, source)};
  atom.name = names.label(name);
  atom.residue = names.label(table.value(row, Residue));
  atom.residue_number = names.label(table.value(row, Number) + table.value(row, Insertion));
  atom.chain = names.label(table.value(row, Chain));
  record.assembly_chain = names.label(table.value(row, AssemblyChain));
  atom.element = element_of(table.value(row, Symbol), name, atom.residue.view());
  record.is_hetatm = table.value(row, Record) == "HETATM";
  const std::string alternate = table.value(row, Alternate);
  if (alternate.size() > 1) {
    throw geometry::RefusedInput(source + ": the alternate location " +
                                 geometry::quoted(alternate) +
                                 " has more than one letter; rename it");
  }
  record.alternate = alternate.empty() ? ' ' : alternate[0];
  if (table.has(Occupancy)) record.occupancy = cif::as_number(table.raw(row, Occupancy), 1.0);
  return record;
}

ParsedFile atoms_of(const AtomTable& table, const std::string& source, ModelSearch& models) {
  if (!table.has(X) || !table.has(Y) || !table.has(Z)) {
    throw geometry::UnreadableInput(
        source + ": the atoms have no Cartn_x, _y and _z; coordinates in Angstrom are needed");
  }
  ParsedFile file;
  file.has_chains = table.has(Chain);
  file.has_hetatms = table.has(Record);
  file.has_elements = true;
  file.has_locations = table.has(Alternate);
  file.atoms.reserve(table.size());
  Names names(source);
  std::set<std::string> begun;
  std::optional<std::string> read;  // the model to read, as the table calls it
  std::string last;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::string model = table.value(row, ModelNumber);
    const bool is_new = (row == 0 || model != last) && begun.insert(model).second;
    if (is_new && models.begin(geometry::parse_integer(model))) read = model;
    last = model;
    if (model == read) file.atoms.push_back(atom_in(table, row, source, names));
  }
  file.long_names = names.long_names();
  return file;
}

}  // namespace

AssemblyTables assembly_tables(std::string_view bytes, const std::string& source) {
  cif::Document document = parse_document(bytes, source);
  AssemblyTables tables;
  const std::vector<std::string> numbers = {
      "id",           "matrix[1][1]", "matrix[1][2]", "matrix[1][3]", "matrix[2][1]",
      "matrix[2][2]", "matrix[2][3]", "matrix[3][1]", "matrix[3][2]", "matrix[3][3]",
      "vector[1]",    "vector[2]",    "vector[3]"};
  for (cif::Block& block : document.blocks) {
    if (!AtomTable(block).has_atoms()) continue;
    for (const auto& row : block.find("_pdbx_struct_assembly_gen.",
                                      {"assembly_id", "oper_expression", "asym_id_list"})) {
      tables.generators.push_back({row.str(0), row.str(1), row.str(2)});
    }
    for (const auto& row : block.find("_pdbx_struct_oper_list.", numbers)) {
      AssemblyTables::Operator& made = tables.operators.emplace_back();
      made.id = row.str(0);
      int column = 0;
      for (std::string& number : made.numbers) number = row.str(++column);
    }
    break;  // the block that atoms are read from
  }
  return tables;
}

ParsedFile parse_mmcif(std::string_view bytes, const std::string& source, ModelSearch& models) {
  cif::Document document = parse_document(bytes, source);
  std::optional<ParsedFile> file;
  for (cif::Block& block : document.blocks) {
    AtomTable table(block);
    if (table.has_atoms() && file) models.pass_over();
    if (!table.has_atoms() || file) continue;
    table.find_lines(bytes);
    file = atoms_of(table, source, models);
  }
  if (file) return *std::move(file);
  throw geometry::UnreadableInput(source + ": has no table _atom_site with atoms; is it mmCIF?");
}

}  // namespace morskin::skin::molecule_formats
