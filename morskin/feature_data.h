#pragma once

/// What `morskin features` adds to the attributes of a mesh: of the molecule's atoms, and operators
/// on the mesh.

#include <vector>

#include "geometry/indexed_mesh.h"
#include "geometry/mesh_attributes.h"
#include "morskin/mesh_attributes.h"
#include "skin/molecule.h"

namespace morskin {

/// The groups of columns that features have.
inline constexpr Datum feature_data[] = {Datum::Normal, Datum::Curvature, Datum::Atom};

/// "hphob", the nearest atom's residue's hydropathy (skin::kyte_doolittle), 0 where it has none.
AtomProperty hydropathy_property(const skin::Molecule& molecule);
/// "partial_charge", elementary charges, between atoms by their shares.
/// @pre  the molecule has charges
AtomProperty charge_property(const skin::Molecule& molecule);

/// By atom: "atom_name", "atom_element", "atom_residue", "atom_residue_number" and "atom_chain" as
/// in the file, "atom_position" and "atom_radius", Angstrom, "atom_hphob", and "atom_charge" where
/// the file gives charges.
std::vector<geometry::NamedArray> atom_arrays(const skin::Molecule& molecule);

/// By vertex, "mass", the lumped one.
geometry::Attribute mass_attribute(const geometry::IndexedMesh& mesh);
/// The cotangent Laplacian as SciPy's csr_array takes it: "laplacian_data", "laplacian_indices",
/// "laplacian_indptr", "laplacian_shape".
std::vector<geometry::NamedArray> laplacian_arrays(const geometry::IndexedMesh& mesh);

}  // namespace morskin
