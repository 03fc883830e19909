#pragma once

/// Thinning: as few triangles as [U] allows, where a length was asked for and the skin bends too
/// much for it. Not in the paper.
///
/// In turns the vertices are evened out, edges made Delaunay, and vertices taken out. Even
/// triangles have small circles for their area, so the next turn can take out more. Nothing is done
/// that breaks [U] or the certificate's conditions, so no vertex has to go in again; for that some
/// edges stay that are not Delaunay. Vertices where the length decides stay where they are, unless
/// they are next to others.

#include <cstddef>
#include <vector>

#include "geometry/run.h"
#include "refine/names.h"

namespace morskin::refine {

/// @param mesh  refined for this sizing; comes out compact
/// @return the number of vertices by which it has fewer
std::size_t thin(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                 const geometry::Run& run = geometry::Run());

/// Makes the mesh finer about places where thinning left too little room for good angles: edges
/// there Delaunay and circles within three quarters of [U], as far as flips and insertions go.
/// @param mesh    comes out compact
/// @param radius  about a place, in length scales
/// @return the number of vertices that went in
std::size_t thicken(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                    const std::vector<Point>& places, double radius,
                    const geometry::Run& run = geometry::Run());

}  // namespace morskin::refine
