#pragma once

/// The dynamic baseline as a method of the mesher.

#include "bench/baselines/growth.h"
#include "morskin/method.h"

namespace morskin::baselines {

/// Grows the skin's mesh to time 0 (growth.h), then refines it once with the operations that all
/// methods share (refine/refinement.h): between two inspections the growing mesh may break [L] and
/// [U] a little, and none takes place at time 0.
///
/// @param growth  its sizing is the mesher's
/// @param counts  where to leave what the growth counted, or nullptr
/// @throws geometry::LimitReached  if doubles do not resolve a state of the skin on its way: then
///                                 the mesh is empty, or grows out of all proportion
/// @pre growth.end == 0
morskin::Mesher dynamic_mesher(const GrowthOptions& growth = {}, GrowthCounts* counts = nullptr);

}  // namespace morskin::baselines
