#pragma once

/// The dual complex K of the weighted points: the simplices of the regular triangulation whose dual
/// cells meet the union of the balls (the alpha complex at level 0). The skin's body is homotopy
/// equivalent to it, which makes it the ground truth of the mesh's topology, found without any
/// mesh. All signs are exact. Source: Edelsbrunner, Skin surfaces (1999).

#include "skin/skin_surface.h"
#include "surface/topology.h"

namespace morskin::skin {

struct DualComplex {
  std::array<std::size_t, 4> simplices{};  ///< of K, by dimension
  std::array<std::size_t, 3> betti{};      ///< components, tunnels, voids of the body

  long euler_characteristic() const {
    return static_cast<long>(simplices[0] + simplices[2]) -
           static_cast<long>(simplices[1] + simplices[3]);
  }
  /// Of the skin, the boundary of the body.
  long skin_euler_characteristic() const { return 2 * euler_characteristic(); }
  std::size_t skin_components() const { return betti[0] + betti[2]; }
  std::size_t skin_genus() const { return betti[1]; }  ///< summed over components
  /// What a mesh of the skin is held against.
  operator surface::Topology() const {
    return {skin_components(), skin_genus(), skin_euler_characteristic()};
  }
};

/// @pre    the skin's facets have not been forgotten (SkinSurface::forget_facets).
/// @throws SingularSkin when the skin is singular: a simplex meets its dual and has
/// weight exactly zero (two balls that just touch, say).
DualComplex dual_complex(const SkinSurface& skin, const geometry::Run& run = geometry::Run());

}  // namespace morskin::skin
