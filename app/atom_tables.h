#pragma once

/// What a molecule's atoms add to what is told of its skin: residues and chains by number, partial
/// charges, and the areas of atoms and residues as a table.

#include <span>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "morskin/mesh_attributes.h"
#include "skin/molecule.h"

namespace morskin::app {

/// What is asked for of "residue" and "chain", each counted from 0 as they begin in the file, and
/// "partial_charge", elementary charges, between atoms by their shares; of "hphob" the nearest
/// atom's, by skin::kyte_doolittle. An atom begins a residue where its residue's name or number, or
/// its chain, is not the one before's.
/// @throws geometry::RefusedInput  charges are asked for by name and the file gives none
std::vector<morskin::AtomProperty> atom_properties(const skin::Molecule& molecule,
                                                   const VertexData& asked);

/// CSV: a row for each atom, then one for each residue, then the total. The columns are of, atom
/// (from 1, the line of `balls`), line (of the molecule's file), chain, residue_number, residue,
/// name, element, radius, area (Angstrom^2). What does not apply is empty.
/// @param areas  by atom
std::string areas_text(std::span<const skin::Atom> atoms, std::span<const double> areas);

}  // namespace morskin::app
