#pragma once

/// The certificate as a file: the witness that certify/verify/ checks, and believes nothing of.

#include <span>
#include <string>

#include "app/arguments.h"
#include "geometry/indexed_mesh.h"
#include "skin/skin_surface.h"

namespace morskin::app {

/// JSON: the top-dimensional simplices of the regular triangulation and, by vertex of the mesh,
/// the corners of the mixed cell that it lies in.
/// @param points  by vertex, as certify::locate_vertices() finds them
std::string certificate_text(const geometry::IndexedMesh& mesh,
                             std::span<const surface::SurfacePoint> points,
                             const skin::SkinSurface& skin, skin::Model model,
                             const certify::Sizing& sizing);

}  // namespace morskin::app
