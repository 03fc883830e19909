#pragma once

/// What mesh files tell of their origin; papers/provenance.md lists the keys.

#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/mesh_hashes.h"
#include "app/molecule_input.h"
#include "geometry/files/mesh_files.h"
#include "geometry/provenance.h"

namespace morskin::app {

constexpr std::string_view certified_verdict = "certified", other_verdict = "not certified";

/// The origin of the meshes of one run.
class MeshOrigin {
 public:
  /// @param arguments  must outlive this
  MeshOrigin(const MeshArguments& arguments, const MoleculeInput& input);

  /// @param sizing  as a size goal has set it
  void set_sizing(const certify::Sizing& sizing) { sizing_ = sizing; }

  /// With the hashes of `mesh` as a file of this format stores it.
  geometry::Provenance provenance(const geometry::IndexedMesh& mesh, geometry::MeshFormat format,
                                  bool is_certified) const;

 private:
  MeshHashes hashes(const geometry::IndexedMesh& mesh, geometry::MeshFormat format) const;

  const MeshArguments& arguments_;
  certify::Sizing sizing_;
  std::string input_sha256_;
  std::string radii_;  ///< where they come from
};

}  // namespace morskin::app
