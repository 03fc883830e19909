#include "morskin/feature_data.h"

#include <cstdint>
#include <string>
#include <utility>

#include "geometry/cotangent_laplacian.h"
#include "skin/hydropathy.h"

namespace morskin {
namespace {

std::vector<double> hydropathies(const skin::Molecule& molecule) {
  std::vector<double> of_atom;
  for (const skin::Atom& atom : molecule.atoms) {
    of_atom.push_back(skin::kyte_doolittle(atom.residue).value_or(0));
  }
  return of_atom;
}

}  // namespace

AtomProperty hydropathy_property(const skin::Molecule& molecule) {
  return {"hphob", hydropathies(molecule), false, true};
}

AtomProperty charge_property(const skin::Molecule& molecule) {
  return {"partial_charge", molecule.charges, true};
}

std::vector<geometry::NamedArray> atom_arrays(const skin::Molecule& molecule) {
  std::vector<double> positions, radii;
  for (const skin::Atom& atom : molecule.atoms) {
    positions.insert(positions.end(), atom.position.data(), atom.position.data() + 3);
    radii.push_back(atom.radius);
  }
  const auto texts = [&](skin::Label skin::Atom::*label) {
    std::vector<std::string> result;
    for (const skin::Atom& atom : molecule.atoms) result.emplace_back((atom.*label).view());
    return result;
  };
  std::vector<geometry::NamedArray> arrays{
      {"atom_name", texts(&skin::Atom::name)},
      {"atom_element", texts(&skin::Atom::element)},
      {"atom_residue", texts(&skin::Atom::residue)},
      {"atom_residue_number", texts(&skin::Atom::residue_number)},
      {"atom_chain", texts(&skin::Atom::chain)},
      {"atom_position", std::move(positions), 3},
      {"atom_radius", std::move(radii)},
      {"atom_hphob", hydropathies(molecule)},
  };
  if (!molecule.charges.empty()) arrays.push_back({"atom_charge", molecule.charges});
  return arrays;
}

geometry::Attribute mass_attribute(const geometry::IndexedMesh& mesh) {
  return {"mass", {"mass"}, geometry::lumped_mass(mesh)};
}

std::vector<geometry::NamedArray> laplacian_arrays(const geometry::IndexedMesh& mesh) {
  geometry::SparseMatrix laplacian = geometry::cotangent_laplacian(mesh);
  const auto size = static_cast<std::int64_t>(mesh.positions.size());
  return {{"laplacian_data", std::move(laplacian.values)},
          {"laplacian_indices", std::move(laplacian.columns)},
          {"laplacian_indptr", std::move(laplacian.offsets)},
          {"laplacian_shape", std::vector<std::int64_t>{size, size}}};
}

}  // namespace morskin
