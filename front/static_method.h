#pragma once

/// The static method (papers/5-static.md): restricted Delaunay refinement from seeds at the
/// critical points of a Morse function.

#include <vector>

#include "certify/sizing.h"
#include "morse/critical_point.h"
#include "refine/delaunay_refinement.h"
#include "surface/mesh.h"
#include "surface/surface.h"

namespace morskin::front {

/// Seeds at critical points, each with two more beside it where there is room: a triangle whose
/// surface ball is small enough for [U] and, with C Q below 0.214, stays empty, so that every
/// component of the skin keeps a facet from the start, and no refinement is needed for it to be
/// found. With a coarser C that is not proved (papers/5-static.md).
///
/// Law:  two seeds, unless of one triangle, are farther apart than 0.9 C Q times the larger of
///       their length scales, which meets [L] where Q^2 > 2.3. A triangle's own edges shrink when
///       it is projected, and beyond largest_proved_C may break [L]. A component has three seeds
///       at least, if a triangle projects at one of its critical points.
std::vector<surface::SurfacePoint> delaunay_seeds(const surface::Surface& surface,
                                                  const std::vector<morse::CriticalPoint>& critical,
                                                  const certify::Sizing& sizing);

struct StaticResult {
  surface::Mesh mesh;
  refine::DelaunayRefinementCounts counts;
  std::size_t open_edges = 0;  ///< where refinement gave up; 0 when the mesh is closed
  bool is_done = false;        ///< no triangle was left too big
};

/// Restricted Delaunay refinement from those seeds.
/// @param surface  all its cells kept: circumcentres of coarse samples lie in all of them
StaticResult static_mesh(const surface::Surface& surface,
                         const std::vector<morse::CriticalPoint>& critical,
                         const certify::Sizing& sizing, const geometry::Run& run = geometry::Run());

}  // namespace morskin::front
