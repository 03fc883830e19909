#pragma once

/// The sweep of a whole surface: by one front from below, as in Algorithm 1, or by fronts of their
/// own in each of many subdomains (papers/4.1-algorithm.md).

#include <cstddef>
#include <optional>
#include <vector>

#include "front/partial_sweep.h"
#include "geometry/run.h"

namespace morskin::front {

/// Sweeps a surface from below with one front, to the end.
SweepResult sweep_once(const surface::Surface& surface, const morse::Guide& guide,
                       const SweepOptions& options = {},
                       const std::optional<CoarseningOptions>& coarsening = {},
                       const std::vector<SweepObserver*>& observers = {},
                       const geometry::Run& run = geometry::Run());

/// So many subdomains, of about equal size, a mesh of so many triangles is worth: a power of two.
std::size_t usual_subdomains(double triangles);
inline constexpr std::size_t max_subdomains = 1 << 16;

/// Sweeps subdomains, each for itself, then what is left bare between two neighbours, and so on up
/// to the whole. The mesh depends on their number, but on no number of threads.
/// @param subdomains  how many, 1 to max_subdomains; of what is no power of two the next below
SweepResult sweep_subdomains(const surface::Surface& surface, const morse::Guide& guide,
                             const SweepOptions& options = {},
                             const std::optional<CoarseningOptions>& coarsening = {},
                             const geometry::Run& run = geometry::Run(),
                             std::optional<std::size_t> subdomains = {});

}  // namespace morskin::front
