#pragma once

/// What mesh files tell of their origin; papers/provenance.md lists the keys.

#include <string>
#include <utility>
#include <vector>

#include "app/arguments.h"
#include "app/mesh_hashes.h"
#include "app/molecule_input.h"
#include "geometry/provenance.h"

namespace morskin::app {

/// The origin of the meshes of one run.
class MeshOrigin {
 public:
  /// @param arguments  must outlive this
  MeshOrigin(const MeshArguments& arguments, const MoleculeInput& input);

  /// Of arguments.surface. @param input_sha256  of the molecule's file or, without one, of the text
  MeshOrigin(const MeshArguments& arguments, std::string input_sha256)
      : arguments_(arguments), sizing_(arguments.sizing), input_sha256_(std::move(input_sha256)) {}

  /// @param sizing  as a size goal has set it
  void set_sizing(const certify::Sizing& sizing) { sizing_ = sizing; }

  /// @param hashes  of the mesh as the file stores it
  geometry::Provenance provenance(const MeshHashes& hashes, std::string_view verdict) const;

 private:
  /// What says whose skin the mesh is.
  void add_molecule(std::vector<geometry::Provenance::Entry>& entries) const;

  const MeshArguments& arguments_;
  certify::Sizing sizing_;
  std::string input_sha256_;
  std::string radii_;  ///< where they come from
};

}  // namespace morskin::app
