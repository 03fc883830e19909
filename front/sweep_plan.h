#pragma once

/// Who sweeps what: the parts of a sweep of a whole surface, each with a region and with the places
/// where its fronts start.

#include <vector>

#include "front/sweep_region.h"
#include "front/tangent_disk.h"
#include "geometry/dissection.h"
#include "morse/guide.h"
#include "surface/surface.h"

namespace morskin::front {

using geometry::Dissection;

/// What one sweep of many has to do.
struct SweepPart {
  SweepRegion region = {};
  std::vector<SurfacePoint> minima = {};   ///< where bowls go, from the lowest up
  std::vector<SurfacePoint> samples = {};  ///< of the surface in its box, in a leaf
};

/// The minima from the lowest up, equal ones by id: where one sweep of all lays its bowls.
std::vector<SurfacePoint> minima_of(const morse::Guide& guide);

/// A part for every box of a dissection. A minimum gets its bowl in the smallest box that holds the
/// bowl with a disk's radius to spare, away from minima that wait for a larger box. Sweeps of
/// smaller boxes lay nothing within the gap that bowls keep from all else: the place is still bare
/// when its turn comes, and no bowl is ever laid upon a finished triangle.
std::vector<SweepPart> sweep_plan(const Dissection& dissection, const morse::Guide& guide,
                                  const surface::Samples& samples, const TangentDisk& disk);

/// Where a part lays its bowls: at its minima, and where a piece of the surface enters a leaf from
/// below, to be swept from there although it need not have a minimum. Such places are found on the
/// way down from the samples.
std::vector<SurfacePoint> bowls_of(const SweepPart& part, const morse::MorseFunction& function,
                                   const TangentDisk& disk);

}  // namespace morskin::front
