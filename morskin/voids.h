#pragma once

/// Voids left out of a mesh, as if they were filled: solvers nearly always want that. With a void
/// go all components of the skin that bound it, those of bodies inside too.

#include <vector>

#include "morskin/prepared_skin.h"
#include "skin/skin_components.h"
#include "skin/void_volume.h"
#include "surface/mesh.h"

namespace morskin {

/// By void, Angstrom^3 (skin::void_volume). In the stage "voids".
std::vector<skin::VolumeBounds> void_volumes(const PreparedSkin& skin, const Run& run = Run());

/// Marks the voids whose volume is proved to be below a bound: those to be left out.
/// @param below  Angstrom^3; infinite for all voids, which then are not measured; 0 for none
/// @throws geometry::RefusedInput  for a bound below 0 or NaN, or a void too narrow to be told
void drop_voids(PreparedSkin& skin, double below, const Run& run = Run());

/// Whether a point of the skin lies on a component that bounds a dropped void.
bool is_on_dropped(const PreparedSkin& skin, const skin::SkinComponents& parts,
                   const surface::SurfacePoint& x);

/// Takes the components that bound dropped voids out of a closed mesh of the whole skin. Each is
/// known by one of its vertices.
void drop_components(const PreparedSkin& skin, surface::Mesh& mesh, const Run& run);

}  // namespace morskin
