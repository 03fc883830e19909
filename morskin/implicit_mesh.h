#pragma once

/// Surfaces that are no skins through the same front, refinement and certificate (section 6;
/// papers/6-implicit-surfaces.md).
///
/// What the dual complex is to a skin, the proved critical points of a height are here: they guide
/// the sweep, and they tell the topology. Minima - saddles + maxima is the Euler characteristic.
/// The number of components needs the mesh too: every component of the surface has a minimum, and
/// a minimum so near to a vertex that both lie on one component is covered by that vertex's
/// component of the mesh.

#include <optional>
#include <vector>

#include "implicit/implicit_surface.h"
#include "morskin/pipeline.h"

namespace morskin {

/// By proved minimum, in their order, the component of the mesh whose image under the flow is the
/// surface's component that the minimum lies on; nothing where no vertex is shown to be so near.
/// Components are numbered by their first triangle.
/// @pre (c1), (c2) and (c3) of the certificate hold, or the answer means nothing
std::vector<std::optional<std::uint32_t>> components_at_minima(
    const geometry::IndexedMesh& mesh, const implicit::PreparedSurface& surface);

/// The certificate, with the topology that the critical points tell. Where some box was left
/// undecided the claim about counts does not hold.
certify::Certificate certify_implicit(const geometry::IndexedMesh& mesh, certify::Hints hints,
                                      const implicit::PreparedSurface& surface,
                                      const certify::Sizing& sizing, const Run& run = Run());

/// Sweeps, refines, delivers and certifies. Stages as make_mesh() has them.
/// @throws geometry::RefusedInput  for options that make no sense, or ask for what only skins have:
///         other methods, gradings, goals of size but by length
MeshResult make_mesh(const implicit::PreparedSurface& surface, const MeshingOptions& options,
                     Observer& observer, const Run& run = Run());

}  // namespace morskin
