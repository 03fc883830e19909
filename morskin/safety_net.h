#pragma once

/// What to do when a mesh does not pass the certificate: for each component of the skin that the
/// sweep made try two other directions, then the static method; with a C above those for which all
/// is proved, the static method at once; after that method, where it was not asked for, the sweep.
/// With a smaller C a fallback is a bug of the sweep to be understood; until it is, the user has a
/// certified mesh and the report says how it came to be.

#include "morskin/pipeline.h"

namespace morskin {

/// Replaces the components that are not certified, or not refined, by certified ones of another
/// run and notes each in result.fallbacks. Components are identified by the body and the void they
/// separate (skin/skin_components.h), and their genus is the critical points'; where rounding
/// leaves either undecided the whole mesh counts as one component.
///
/// Does nothing without options.has_safety_net, nor where a method but the sweep or a guard but the
/// general one was asked for: what those make is shown as it is.
/// @param options  those of the run, with its method; their mesher makes the other sweeps
/// @param is_method_free  no method was asked for
/// @return whether the mesh was changed; if so, its certificate is out of date
bool mend(const PreparedSkin& skin, const MeshingOptions& options, bool is_method_free,
          MeshResult& result, const Run& run);

}  // namespace morskin
