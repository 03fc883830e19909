#pragma once

/// The static method (papers/5-static.md): restricted Delaunay refinement from seeds at the
/// critical points of a Morse function.

#include <vector>

#include "front/method.h"

namespace morskin::front {

/// Seeds at critical points, each with two more beside it where there is room: a triangle whose
/// surface ball stays empty and small enough for [U], so that every component of the skin keeps a
/// facet from the start, and no refinement is needed for it to be found.
///
/// Law:  two seeds are farther apart than 0.9 C Q times their larger length scale, which meets [L]
///       where Q^2 > 2.3. Every component has three seeds at least.
std::vector<skin::SurfacePoint> delaunay_seeds(const skin::SkinSurface& skin,
                                               const std::vector<morse::CriticalPoint>& critical,
                                               const refine::Sizing& sizing);

/// @throws morse::DegenerateFunction
MethodResult static_method(const PreparedSkin& skin, const MeshOptions& options);

}  // namespace morskin::front
