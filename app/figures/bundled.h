#pragma once

#include <span>
#include <string_view>

#include "morskin/prepared_skin.h"
#include "skin/model.h"
#include "skin/molecule.h"

namespace morskin::figures {

/// A file of bench/molecules, kept in the program.
struct BundledMolecule {
  std::string_view name, text;
};
std::span<const BundledMolecule> bundled_molecules();

/// @pre  one of them has this name
skin::Molecule bundled_molecule(std::string_view name);
morskin::PreparedSkin bundled_skin(std::string_view name, skin::Model model = skin::Model::Paper,
                                   double probe = 1.4);

}  // namespace morskin::figures
