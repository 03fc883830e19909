#pragma once

/// The parts of the pipeline (pipeline.h) that know their surface by the seam only, so that skins
/// and other surfaces go the same way.

#include <functional>
#include <vector>

#include "morskin/pipeline.h"

namespace morskin {

/// @throws geometry::RefusedInput  for options that make no sense
void require_sound(const MeshingOptions& options);
/// With what the certificate is to claim of angles, by the goal.
MeshingOptions with_claimed_angle(MeshingOptions options);

/// Sweeps a surface along a guide and refines.
/// @param guard  instead of the general one
MethodResult sweep_along(const surface::Surface& surface, const morse::Guide& guide,
                         const MeshingOptions& options, const front::GuardPolicy* guard,
                         Observer& observer, const Run& run);

/// Raises angles to the goal by moves, then those below 30 degrees by insertions.
void raise_angles(const surface::Surface& surface, const MeshingOptions& options,
                  MethodResult& made, const Run& run);

/// A mesh on its way from the mesher to the certificate, with what is known of it.
struct Parcel {
  MeshResult result;
  std::vector<geometry::HalfEdgeId> twins;  ///< by half-edge

  /// Empties the mesh that it is made from, so that little is there twice.
  /// @param options  of the run, with its method
  Parcel(MethodResult made, const MeshingOptions& options, const Run& run);
};

using Certifying =
    std::function<certify::Certificate(const geometry::IndexedMesh&, certify::Hints)>;

/// Delivers the mesh of a result and certifies what has arrived.
void deliver(MeshResult& result, std::vector<geometry::HalfEdgeId> twins, const Certifying& certify,
             Observer& observer, const Run& run);

}  // namespace morskin
