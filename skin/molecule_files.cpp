#include "skin/molecule_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/exact_range.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/gzip.h"
#include "geometry/files/text_lines.h"
#include "skin/assembly.h"
#include "skin/model.h"
#include "skin/molecule_formats.h"

namespace morskin::skin {
namespace {

using geometry::parse_double;
using geometry::RefusedInput;
using geometry::take_field;
using geometry::TextLines;
using geometry::trimmed;
using geometry::UnreadableInput;
using molecule_formats::Assembly;
using molecule_formats::AtomRecord;
using molecule_formats::ModelSearch;
using molecule_formats::ParsedFile;

constexpr double largest_number = 1e6;      // Angstrom; coordinates and radii
constexpr std::size_t pdb_line_bytes = 80;  // an assembly has no more atoms than a file can

constexpr std::array<std::pair<std::string_view, MoleculeFormat>, 9> endings = {{
    {".pdb", MoleculeFormat::Pdb},
    {".ent", MoleculeFormat::Pdb},
    {".pdb1", MoleculeFormat::Pdb},
    {".cif", MoleculeFormat::Mmcif},
    {".mmcif", MoleculeFormat::Mmcif},
    {".pqr", MoleculeFormat::Pqr},
    {".xyz", MoleculeFormat::Xyz},
    {".xyzr", MoleculeFormat::Xyzr},
    {".xyzw", MoleculeFormat::Xyzw},
}};

bool is_four_numbers(std::string_view line) {
  for (int i = 0; i < 4; ++i) {
    if (!parse_double(take_field(line))) return false;
  }
  return true;
}

// An atom line of a PDB file has two decimals of occupancy and temperature factor in fixed columns;
// that of a PQR file has its radius at the end.
bool is_pqr_atom(std::string_view line) {
  if (line.size() >= 66 && line[57] == '.' && line[63] == '.') return false;
  const std::vector<std::string_view> fields = geometry::fields_of(line);
  const bool has_serial_apart = fields[0] == "ATOM" || fields[0] == "HETATM";
  const std::size_t count = fields.size() + (has_serial_apart ? 0 : 1);
  if (count < 10 || count > 11) return false;
  return std::all_of(fields.end() - 5, fields.end(),
                     [](std::string_view field) { return parse_double(field).has_value(); });
}

std::optional<MoleculeFormat> format_by_content(std::string_view bytes) {
  TextLines lines(bytes, "");
  bool is_pdb = false;  // a line began with a record name, though no atom came yet
  while (lines.advance()) {
    const std::string_view line = lines.line();
    std::string_view fields = line;
    const std::string_view word = take_field(fields);
    if (trimmed(line) == molecule_formats::weights_line) return MoleculeFormat::Xyzw;
    if (word.empty() || word[0] == '#') continue;
    if (molecule_formats::is_pqr_record(word)) {
      return is_pqr_atom(line) ? MoleculeFormat::Pqr : MoleculeFormat::Pdb;
    }
    if (is_pdb) continue;
    if (word.starts_with("data_")) return MoleculeFormat::Mmcif;
    if (is_four_numbers(line)) return MoleculeFormat::Xyzr;
    if (geometry::parse_integer(word) && trimmed(fields).empty()) return MoleculeFormat::Xyz;
    is_pdb = word.size() >= 3 && word.size() <= 6 && std::ranges::all_of(word, [](char c) {
               return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
             });
    if (!is_pdb) return std::nullopt;
  }
  return std::nullopt;
}

ParsedFile parse(std::string_view bytes, const std::string& source, MoleculeFormat format,
                 ModelSearch& models) {
  switch (format) {
    case MoleculeFormat::Pdb:
      return molecule_formats::parse_pdb(bytes, source, models);
    case MoleculeFormat::Mmcif:
      return molecule_formats::parse_mmcif(bytes, source, models);
    case MoleculeFormat::Pqr:
      return molecule_formats::parse_pqr(bytes, source, models);
    case MoleculeFormat::Xyz:
      return molecule_formats::parse_xyz(bytes, source, models);
    case MoleculeFormat::Xyzr:
      return molecule_formats::parse_xyzr(bytes, source, models);
    case MoleculeFormat::Xyzw:
      return molecule_formats::parse_xyzw(bytes, source, models);
  }
  return {};
}

[[noreturn]] void refuse(const std::string& source, const Atom& atom, const std::string& what) {
  const std::string line = atom.line > 0 ? ":" + std::to_string(atom.line) : "";
  throw RefusedInput(source + line + ": " + describe(atom) + " " + what);
}

void give_radius(Atom& atom, const RadiusTable& table, const std::string& source) {
  const std::optional<double> radius = table.radius(atom);
  if (!radius) {
    const std::string element = atom.element.is_empty()
                                    ? "no known element"
                                    : "element " + geometry::quoted(atom.element.view());
    refuse(source, atom,
           "has " + element +
               ", for which there is no van der Waals radius in the table of radii; remove the "
               "atom, take another table, or give radii in a PQR or XYZR file");
  }
  atom.radius = *radius;
}

void check_range(const Atom& atom, const std::string& source) {
  if (!atom.position.allFinite())
    refuse(source, atom, "has a coordinate that is not finite; remove it");
  if (atom.position.cwiseAbs().maxCoeff() > largest_number) {
    refuse(source, atom, "lies more than 10^6 Angstrom from the origin; remove or move it");
  }
  if (!(atom.radius >= 0) || atom.radius > largest_number) {
    refuse(source, atom, "has a radius that is not between 0 and 10^6 Angstrom; correct it");
  }
}

void check_weight(const AtomRecord& record, const std::string& source) {
  if (record.weight > 0 && record.weight <= geometry::largest_exact) return;
  refuse(source, record.atom,
         "has a weight that is not above 0 and at most 2^30 Angstrom^2; correct it");
}

void check_charge(const AtomRecord& record, const std::string& source) {
  if (std::isfinite(record.charge)) return;
  refuse(source, record.atom, "has a charge that is not finite; correct it");
}

// How many atoms have the position and radius of an earlier one.
std::size_t count_duplicates(const std::vector<Atom>& atoms) {
  std::vector<std::array<double, 4>> balls;
  balls.reserve(atoms.size());
  for (const Atom& atom : atoms) {
    balls.push_back({atom.position.x(), atom.position.y(), atom.position.z(), atom.radius});
  }
  std::ranges::sort(balls);
  const auto distinct_end = std::unique(balls.begin(), balls.end());
  return static_cast<std::size_t>(balls.end() - distinct_end);
}

/// The table to take radii from; nothing where the file's own count.
std::optional<RadiusTable> table_for(const ParsedFile& file, const std::string& source,
                                     const std::optional<RadiusTable>& asked) {
  if (!asked)
    return file.has_radii || file.has_weights ? std::nullopt : std::optional(RadiusTable());
  if (file.has_elements) return asked;
  throw RefusedInput(source + ": does not tell elements, so no table gives its atoms radii; read " +
                     "it without one");
}

std::string radii_in_words(const Molecule& molecule, const std::optional<RadiusTable>& table) {
  if (table) return table->text_for(molecule.atoms);
  return molecule.weights.empty() ? "input" : "weights";
}

Molecule finish(ParsedFile file, const std::string& source, const ReadOptions& options,
                const std::optional<Assembly>& assembly) {
  const std::optional<RadiusTable> table = table_for(file, source, options.radii);
  Molecule molecule;
  molecule.source = source;
  molecule.counts = molecule_formats::keep_selected(file, options.selection, source);
  if (assembly) {
    molecule.counts.other_chains += molecule_formats::assemble(file.atoms, *assembly, source,
                                                               options.max_bytes / pdb_line_bytes);
  }
  molecule.atoms.reserve(file.atoms.size());
  for (AtomRecord& record : file.atoms) {
    if (file.has_weights) {
      check_weight(record, source);
      record.atom.radius = patch_radius(record.weight);
    } else if (table) {
      give_radius(record.atom, *table, source);
    }
    check_range(record.atom, source);
    if (record.atom.radius == 0) {
      ++molecule.counts.zero_radii;
      continue;
    }
    molecule.atoms.push_back(record.atom);
    if (file.has_weights) molecule.weights.push_back(record.weight);
    if (!file.has_charges) continue;
    check_charge(record, source);
    molecule.charges.push_back(record.charge);
  }
  if (molecule.atoms.empty()) {
    const char* const kind = molecule.counts.zero_radii > 0 ? " with a radius above 0"
                             : molecule.counts.unknown > 0  ? " of a known element"
                                                            : "";
    throw RefusedInput(source + ": has no atom" + kind + "; name another file");
  }
  molecule.counts.duplicates = count_duplicates(molecule.atoms);
  molecule.radii = radii_in_words(molecule, table);
  return molecule;
}

/// A file's text and what it is.
struct OpenedFile {
  std::string unpacked;  ///< empty if the bytes were text
  std::string_view text;
  MoleculeFormat format;
};

void open(OpenedFile& file, std::string_view bytes, const std::string& source,
          const ReadOptions& options) {
  if (geometry::is_gzip(bytes)) {
    file.unpacked = geometry::unpack_gzip(bytes, source, options.max_bytes);
    bytes = file.unpacked;
  }
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  if (trimmed(bytes).empty()) throw UnreadableInput(source + ": is empty; name another file");
  std::optional<MoleculeFormat> format = options.format;
  if (!format) format = molecule_format_of(source);
  if (!format) {
    format = format_by_content(bytes);
    if (format == MoleculeFormat::Xyzr && options.are_weights) format = MoleculeFormat::Xyzw;
  }
  if (!format) {
    throw UnreadableInput(source +
                          ": is no molecule that can be recognised; use PDB, mmCIF, PQR, XYZ, "
                          "XYZR or XYZW and the ending of that name");
  }
  file.text = bytes;
  file.format = *format;
}

std::optional<Assembly> assembly_in(const OpenedFile& file, const std::string& source,
                                    const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  if (file.format == MoleculeFormat::Pdb) {
    return molecule_formats::pdb_assembly(file.text, source, *name);
  }
  if (file.format == MoleculeFormat::Mmcif) {
    return molecule_formats::mmcif_assembly(file.text, source, *name);
  }
  throw RefusedInput(source + ": only PDB and mmCIF tell of biological assemblies; read it " +
                     "without one");
}

}  // namespace

std::optional<MoleculeFormat> molecule_format_of(const std::filesystem::path& path) {
  std::filesystem::path name = geometry::lower_case(path.filename().string());
  if (name.extension() == ".gz") name = name.stem();
  const std::string ending = name.extension().string();
  for (const auto& [known, format] : endings) {
    if (ending == known) return format;
  }
  return std::nullopt;
}

Molecule parse_molecule(std::string_view bytes, const std::string& source,
                        const ReadOptions& options) {
  OpenedFile file;
  open(file, bytes, source, options);
  const auto assembly = assembly_in(file, source, options.selection.assembly);
  ModelSearch models(options.selection.model);
  ParsedFile parsed = parse(file.text, source, file.format, models);
  const std::size_t other_models = models.others(source);
  Molecule molecule = finish(std::move(parsed), source, options, assembly);
  molecule.counts.other_models = other_models;
  return molecule;
}

std::vector<std::int64_t> model_numbers(std::string_view bytes, const std::string& source,
                                        const ReadOptions& options) {
  OpenedFile file;
  open(file, bytes, source, options);
  ModelSearch models = ModelSearch::of_none();
  parse(file.text, source, file.format, models);
  return models.numbers(source);
}

Molecule read_molecule(const std::filesystem::path& path, const ReadOptions& options) {
  const geometry::FileBytes bytes = geometry::read_file(path, options.max_bytes);
  return parse_molecule(bytes.view(), path.string(), options);
}

}  // namespace morskin::skin
