#pragma once

/// Algorithm 1 from one front, with the changes to what the paper prints undone one at a time: what
/// is each worth? papers/5-results.md has the table. Measurements only; most of these meshes are
/// worse and some sweeps fail.

#include <array>
#include <string_view>
#include <utility>

#include "front/tangent_disk.h"
#include "morskin/method.h"

namespace morskin::ablation {

/// What is done as the paper prints it; everything else is morskin's.
struct AsPrinted {
  bool radius = false;        ///< 4.2: r_a = 0.208 rho instead of 0.87 of it
  bool length_scale = false;  ///< 4.2: rho at the departure vertex, whatever it is at the rim
  bool sectors = false;       ///< 4.1: ceil(angle / 60 degrees) instead of the nearest
  bool wings = false;         ///< 4.1: below 90 degrees instead of 75
  bool edges = false;         ///< 4.1 has no rule for large ears and long edges
  bool guard = false;         ///< 3.1: collisions are looked for in protecting spheres only
  bool contraction = false;   ///< 3.2: arcs are contracted by distance, not by persistence
  bool refinement = false;    ///< Algorithm 1, line 14: in the loop instead of after the sweep
};

using Switch = std::pair<std::string_view, bool AsPrinted::*>;
inline constexpr std::array<Switch, 8> switches{{{"radius", &AsPrinted::radius},
                                                 {"length-scale", &AsPrinted::length_scale},
                                                 {"sectors", &AsPrinted::sectors},
                                                 {"wings", &AsPrinted::wings},
                                                 {"edges", &AsPrinted::edges},
                                                 {"guard", &AsPrinted::guard},
                                                 {"contraction", &AsPrinted::contraction},
                                                 {"refinement", &AsPrinted::refinement}}};

front::Spacing spacing(const AsPrinted& printed);

/// For MeshingOptions::mesher. With nothing as printed its meshes are the pipeline's from one
/// front, unsmoothed.
Mesher mesher(const AsPrinted& printed);

}  // namespace morskin::ablation
