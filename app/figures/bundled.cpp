#include "app/figures/bundled.h"

#include <stdexcept>
#include <string>

#include "skin/molecule_files.h"

namespace morskin::figures {

skin::Molecule bundled_molecule(std::string_view name) {
  for (const BundledMolecule& molecule : bundled_molecules()) {
    if (molecule.name == name) return skin::parse_molecule(molecule.text, std::string(name));
  }
  throw std::logic_error("no bundled molecule " + std::string(name));
}

morskin::PreparedSkin bundled_skin(std::string_view name, skin::Model model, double probe) {
  return morskin::prepare_skin(skin::weighted_points(bundled_molecule(name), model, probe));
}

}  // namespace morskin::figures
