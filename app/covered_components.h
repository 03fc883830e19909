#pragma once

/// Which component of a mesh lies on which of the surface.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/molecule_input.h"
#include "geometry/indexed_mesh.h"
#include "geometry/mesh_check.h"
#include "implicit/implicit_surface.h"
#include "morskin/prepared_skin.h"
#include "surface/surface_point.h"

namespace morskin::app {

/// A component of the skin and the mesh's components that lie on it: one, if all is well, or none
/// if it is dropped.
struct CoveredComponent {
  std::string name;  ///< "outer surface of the body with atom CA of ALA 12"
  bool is_dropped;
  std::vector<std::uint32_t> by;
  std::string absence = "is missing";  ///< what is said where there is none

  bool is_well() const { return by.size() == (is_dropped ? 0 : 1); }
};

/// The mesh's components on each of the skin's, by their vertices nearest to it. Empty if rounding
/// makes the skin's indistinguishable.
/// @param topology  of the mesh
/// @param points    by vertex
std::vector<CoveredComponent> covered_components(const MoleculeInput& input,
                                                 const morskin::PreparedSkin& skin,
                                                 const geometry::IndexedMesh& mesh,
                                                 const geometry::MeshCheck& topology,
                                                 std::span<const surface::SurfacePoint> points);

/// The surface's components by their minima, and those of the mesh that cover them.
std::vector<CoveredComponent> components_by_minima(const geometry::IndexedMesh& mesh,
                                                   const implicit::PreparedSurface& prepared);

}  // namespace morskin::app
