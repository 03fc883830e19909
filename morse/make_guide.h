#pragma once

#include <functional>
#include <optional>

#include "geometry/run.h"
#include "morse/choose_function.h"
#include "morse/guide.h"
#include "morse/simplification.h"

namespace morskin::morse {

/// A way of simplifying a complex with protecting spheres of this radius over the length scale.
using Contraction = std::function<Simplification(const MorseSmaleComplex&, double radius_share)>;

/// Chooses the function and, if protecting spheres overlap, simplifies its Morse-Smale complex.
/// Stages "critical points" and "integral lines".
/// @param euler_characteristic  of the skin
/// @param asked                 the requested function, if any; see choose_function()
/// @param radius_share          radius of a protecting sphere over the length scale at its centre
/// @throws DegenerateFunction
Guide make_guide(const skin::SkinSurface& skin, long euler_characteristic,
                 const std::optional<MorseFunction>& asked, double radius_share,
                 const geometry::Run& run = geometry::Run(),
                 const Contraction& contract = contract_short_arcs);

}  // namespace morskin::morse
