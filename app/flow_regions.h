#pragma once

/// The region of the Morse-Smale complex that each triangle of a mesh lies in, by the minimum and
/// the maximum at the ends of the integral line through its centroid (section 3.2).
///
/// For pictures. The lines are those of the function interpolated linearly on every triangle, so
/// the borders of regions are off the skin's integral lines by a triangle or so, and by more where
/// many lines are close. A triangle whose pair belongs to no region takes a neighbour's.

#include <cstdint>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "geometry/run.h"
#include "morse/morse_smale_complex.h"

namespace morskin::app {

/// A pair of extrema, by their indices among the critical points.
struct FlowRegion {
  std::uint32_t minimum, maximum;
  friend auto operator<=>(const FlowRegion&, const FlowRegion&) = default;
};

struct FlowRegions {
  std::vector<FlowRegion> regions;         ///< ascending
  std::vector<std::uint32_t> of_triangle;  ///< into regions
};

/// @param complex  without regions every pair is accepted
/// @pre  the mesh is a closed 2-manifold; there are a minimum and a maximum.
FlowRegions flow_regions(const geometry::IndexedMesh& mesh, const morse::MorseFunction& function,
                         const morse::MorseSmaleComplex& complex, const geometry::Run& run);

}  // namespace morskin::app
