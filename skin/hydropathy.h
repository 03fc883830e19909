#pragma once

#include <optional>

#include "skin/molecule.h"

namespace morskin::skin {

/// The hydropathy of an amino acid by the name of its residue, from -4.5 (arginine) to 4.5
/// (isoleucine); nothing for other residues. Names that tell the protonation, a bridge or the end
/// of a chain (HID, CYX, NALA), as force fields have them, and selenomethionine count as the amino
/// acid.
/// Source: Kyte & Doolittle 1982, table 2.
std::optional<double> kyte_doolittle(const Label& residue);

}  // namespace morskin::skin
