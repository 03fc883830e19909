#include "skin/molecule.h"

namespace morskin::skin {

std::string describe(const Atom& atom) {
  const auto with = [](std::string_view before, const Label& label) {
    return label.is_empty() ? std::string() : std::string(before) + std::string(label.view());
  };
  std::string text = "ball";
  if (!atom.element.is_empty()) text = std::string(atom.element.view()) + " atom";
  if (!atom.name.is_empty()) {
    text = "atom " + std::string(atom.name.view()) + with(" of ", atom.residue) +
           with(" ", atom.residue_number) + with(" chain ", atom.chain);
  }
  if (atom.line > 0) text += " (line " + std::to_string(atom.line) + ")";
  return text;
}

std::string describe(const Molecule& molecule, geometry::AtomId atom) {
  const Atom& described = molecule.atoms[atom.index()];
  std::string text = describe(described);
  if (described.line == 0) text += " (number " + std::to_string(atom.index() + 1) + ")";
  return text;
}

}  // namespace morskin::skin
