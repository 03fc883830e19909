#pragma once

/// What to do when the sweep's mesh does not pass the certificate: for each component of the skin
/// try two other directions, then the static method; with a C above those for which all is proved,
/// the static method at once. For smaller ones a fallback is a bug of the sweep to be understood;
/// until it is, the user has a certified mesh and the report says how it came to be.

#include "morskin/pipeline.h"

namespace morskin {

/// Replaces the components that are not certified, or not refined, by certified ones of another
/// run and notes each in result.fallbacks. Components are identified by the body and the void they
/// separate (skin/skin_components.h), and their genus is the critical points'; where rounding
/// leaves either undecided the whole mesh counts as one component.
///
/// Does nothing without options.has_safety_net, nor after anything but a sweep with the general
/// guard: what other methods and guards make is shown as it is.
/// @param options  those of the run; their mesher makes the other sweeps
/// @return whether the mesh was changed; if so, its certificate is out of date
bool mend(const PreparedSkin& skin, const MeshingOptions& options, MeshResult& result,
          const Run& run);

}  // namespace morskin
