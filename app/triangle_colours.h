#pragma once

/// The colours that `render` gives to triangles, and their meaning.

#include <vector>

#include "app/picture_arguments.h"
#include "app/pictures/legend.h"
#include "geometry/indexed_mesh.h"

namespace morskin::app {

struct TriangleColours {
  std::vector<pictures::Colour> colours;  ///< by triangle; empty for that of the whole mesh
  std::size_t components = 0;             ///< counted only if they are coloured
};

TriangleColours triangle_colours(const geometry::IndexedMesh& mesh, ColourBy by);

/// @param components  the most of any mesh in the picture
/// @param has_border  whether a mesh in the picture has edges of one triangle only
/// @param shows_inside  whether inner sides of triangles may be seen
pictures::Legend legend_of(const RenderArguments& arguments, std::size_t components,
                           bool has_border, bool shows_inside);

/// Of edges that only one triangle has.
inline constexpr pictures::Colour border_red = pictures::Colour::of(0xe02d2d);

}  // namespace morskin::app
