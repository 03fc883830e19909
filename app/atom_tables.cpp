#include "app/atom_tables.h"

#include <map>
#include <numeric>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "morskin/feature_data.h"

namespace morskin::app {
namespace {

bool is_same_residue(const skin::Atom& a, const skin::Atom& b) {
  return a.chain == b.chain && a.residue_number == b.residue_number && a.residue == b.residue;
}

/// A field of CSV, between quotation marks where it has to be.
std::string field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void append_residue(std::string& text, const skin::Atom& atom) {
  text += field(atom.chain.view()) + ',' + field(atom.residue_number.view()) + ',' +
          field(atom.residue.view()) + ',';
}

void append_area(std::string& text, double area) {
  geometry::append_number(text, area);
  text += '\n';
}

std::vector<morskin::AtomProperty> residue_properties(std::span<const skin::Atom> atoms) {
  morskin::AtomProperty residue{"residue", {}}, chain{"chain", {}};
  std::map<skin::Label, double> chains;
  double count = -1;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (i == 0 || !is_same_residue(atoms[i - 1], atoms[i])) ++count;
    residue.of_atom.push_back(count);
    const auto number = static_cast<double>(chains.size());
    chain.of_atom.push_back(chains.try_emplace(atoms[i].chain, number).first->second);
  }
  return {residue, chain};
}

}  // namespace

std::vector<morskin::AtomProperty> atom_properties(const skin::Molecule& molecule,
                                                   const VertexData& asked) {
  std::vector<morskin::AtomProperty> properties;
  if (asked.residues) properties = residue_properties(molecule.atoms);
  if (asked.features) properties.push_back(hydropathy_property(molecule));
  if (!asked.charges) return properties;
  if (!molecule.charges.empty()) {
    properties.push_back(charge_property(molecule));
  } else if (!asked.is_all) {
    throw geometry::RefusedInput(molecule.source +
                                 ": gives no charges, which --vertex-data charge asks for; name a "
                                 "PQR file");
  }
  return properties;
}

std::string areas_text(std::span<const skin::Atom> atoms, std::span<const double> areas) {
  std::string text = "of,atom,line,chain,residue_number,residue,name,element,radius,area\n";
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const skin::Atom& atom = atoms[i];
    text += "atom," + std::to_string(i + 1) + ',';
    text += (atom.line > 0 ? std::to_string(atom.line) : "") + ',';
    append_residue(text, atom);
    text += field(atom.name.view()) + ',' + field(atom.element.view()) + ',';
    geometry::append_number(text, atom.radius);
    text += ',';
    append_area(text, areas[i]);
  }
  for (std::size_t i = 0, end = 0; i < atoms.size(); i = end) {
    double sum = 0;
    for (; end < atoms.size() && is_same_residue(atoms[i], atoms[end]); ++end) sum += areas[end];
    text += "residue,,,";
    append_residue(text, atoms[i]);
    text += ",,,";
    append_area(text, sum);
  }
  text += "total,,,,,,,,,";
  append_area(text, std::accumulate(areas.begin(), areas.end(), 0.0));
  return text;
}

}  // namespace morskin::app
