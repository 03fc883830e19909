#pragma once

/// Which region of the Morse-Smale complex each triangle of a mesh lies in: told by the minimum and
/// the maximum that the integral line through its middle runs between (section 3.2).
///
/// For pictures. The lines are those of the function made linear on every triangle, so the borders
/// of the regions are off the integral lines of the skin by a triangle or so, and where many run
/// side by side by more. A triangle whose pair no region of the complex has takes a neighbour's.

#include <cstdint>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "morse/morse_smale_complex.h"

namespace morskin::app {

/// A pair of extrema, by their places among the critical points.
struct FlowRegion {
  std::uint32_t minimum, maximum;
  friend auto operator<=>(const FlowRegion&, const FlowRegion&) = default;
};

struct FlowRegions {
  std::vector<FlowRegion> regions;         ///< ascending
  std::vector<std::uint32_t> of_triangle;  ///< into regions
};

/// @param complex  its regions may be missing: then every pair is let pass
/// @param threads  at most; the answer is the same for any number
/// @pre  the mesh is a closed 2-manifold; there are a minimum and a maximum.
FlowRegions flow_regions(const geometry::IndexedMesh& mesh, const morse::MorseFunction& function,
                         const morse::MorseSmaleComplex& complex, unsigned threads);

}  // namespace morskin::app
