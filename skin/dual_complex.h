#pragma once

/// The dual complex K of the weighted points: the simplices of the regular triangulation whose dual
/// cells meet the union of the balls (the alpha complex at level 0). The skin's body is homotopy
/// equivalent to it, so it gives the topology of the skin without any mesh. All signs are exact.
/// Source: Edelsbrunner, Deformable smooth surface design (1999).

#include <array>
#include <cstdint>
#include <vector>

#include "skin/skin_surface.h"
#include "surface/topology.h"

namespace morskin::skin {

/// A bounded component of the complement of the skin's body.
struct Void {
  /// The deepest orthocentre in it, rounded, and its tetrahedron. About it a ball of radius
  /// `clearance`, Angstrom, is free; `point_in_free_ball` is exact about that.
  std::uint32_t tetrahedron;
  Point centre;
  double clearance;
  /// The components of the body about and in it, ascending. The skin has one component between each
  /// of them and the void.
  std::vector<std::uint32_t> bodies;
  long euler_characteristic = 0;  ///< of the void itself; that of its boundary is twice as large
};

struct DualComplex {
  static constexpr std::uint32_t no_part = 0xFFFFFFFF;

  std::array<std::size_t, 4> simplices{};   ///< of K, by dimension
  std::array<std::size_t, 3> betti{};       ///< components, tunnels, voids of the body
  std::vector<AtomId> bodies;               ///< the first atom of each component of the body
  std::vector<std::uint32_t> outer_bodies;  ///< those that border on the outside, ascending
  std::vector<Void> voids;
  /// By index in the triangulation: the part that the deepest points of its mixed cell lie in.
  std::vector<std::uint32_t> body_of_vertex;       ///< no_part if not in K
  std::vector<std::uint32_t> void_of_tetrahedron;  ///< no_part if in K or outside

  long euler_characteristic() const {
    return static_cast<long>(simplices[0] + simplices[2]) -
           static_cast<long>(simplices[1] + simplices[3]);
  }
  /// Of the skin, the boundary of the body.
  long skin_euler_characteristic() const { return 2 * euler_characteristic(); }
  std::size_t skin_components() const { return betti[0] + betti[2]; }
  std::size_t skin_genus() const { return betti[1]; }  ///< summed over components
  /// Of the skin, to compare a mesh with.
  operator surface::Topology() const {
    return {skin_components(), skin_genus(), skin_euler_characteristic()};
  }
};

/// @pre    SkinSurface::forget_facets() has not been called.
/// @throws SingularSkin where a simplex meets its dual and has weight exactly zero (two balls that
///         touch at a point, say).
DualComplex dual_complex(const SkinSurface& skin, const geometry::Run& run = geometry::Run());

}  // namespace morskin::skin
