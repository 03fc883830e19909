#pragma once

/// What the words typed for `mesh` ask for, checked; some of it is asked of other commands too.

#include <optional>

#include "app/arguments.h"
#include "app/options.h"
#include "morse/morse_function.h"

namespace morskin::app {

/// Of --height and --function, of which at most one may be given.
/// @throws UsageError
std::optional<morse::MorseFunction> parsed(const Typed& typed);

/// Of --density and --triangles; with --size three ways to say one thing.
/// @throws UsageError
void finish(morskin::SizeGoal& goal, const Typed& typed);

/// @throws UsageError
void finish(MeshArguments& mesh, const Typed& typed);

}  // namespace morskin::app
