#pragma once

/// The options of `features`, which is `mesh` with other defaults.

#include <array>

#include "app/options.h"

namespace morskin::app {

/// What `mesh` lets choose and `features` sets.
inline constexpr std::array features_lack{"--vertex-data", "--decimals", "--order", "--grid",
                                          "--grow"};

void add_features(CLI::App& app, FeaturesArguments& features, Typed& typed);

/// Fills in what `features` does unless told otherwise: a skin like the solvent-excluded surface,
/// without voids, at two vertices per square Angstrom.
void set_feature_defaults(Typed& typed, const FeaturesArguments& features);

/// What is written and how, and which endings may be.
/// @throws UsageError
void finish_features(FeaturesArguments& features);

}  // namespace morskin::app
