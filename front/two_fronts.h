#pragma once

/// Two sweeps at once: one from the minima up, one from the maxima down (the Morse function
/// reversed), each in its own thread. Both stop a few edges before a middle level; then one
/// absorbs the other and closes the strip between.
///
/// The paper sweeps once, from below (section 4.1). The direction is open there
/// ("our algorithm can generate correct mesh with different directions"), and neither sweep
/// touches what the other has laid before they are joined, so the mesh does not depend on the
/// number of threads.

#include <optional>
#include <vector>

#include "front/partial_sweep.h"
#include "surface/surface.h"

namespace morskin::front {

/// One sweep from below, as in Algorithm 1.
/// @param coarsening  behind the front, or none
/// @param observers   must outlive the call
/// @param run         receives the share of atoms that are passed
SweepResult sweep_once(const surface::Surface& skin, const morse::Guide& guide,
                       const SweepOptions& options = {},
                       const std::optional<CoarseningOptions>& coarsening = {},
                       const std::vector<SweepObserver*>& observers = {},
                       const geometry::Run& run = geometry::Run());

/// From both ends; on one thread the two sweeps run one after the other.
SweepResult sweep_from_both_ends(const surface::Surface& skin, const morse::Guide& guide,
                                 const SweepOptions& options = {},
                                 const std::optional<CoarseningOptions>& coarsening = {},
                                 const geometry::Run& run = geometry::Run(2));

/// The level where they meet: as near as can be to the median value over the atoms, so that both
/// have about as much to do, but never between a minimum below and a maximum above that are so
/// close to each other that their bowls might overlap.
double middle_level(const surface::Surface& skin, const morse::Guide& guide);

}  // namespace morskin::front
