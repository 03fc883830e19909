#pragma once

/// The certificate as a file: the witness that certify/verify/ checks, and believes nothing of.

#include <span>
#include <string>

#include "certify/sizing.h"
#include "geometry/indexed_mesh.h"
#include "morskin/prepared_skin.h"

namespace morskin::app {

/// JSON: the top-dimensional simplices of the regular triangulation; the number of voids that are
/// left out; by component of the mesh a vertex at which it covers the skin once; by vertex the
/// corners of the mixed cell it lies in.
/// @param points  by vertex, as certify::locate_vertices() finds them
/// @param component_vertices  as certify::certify() finds them; none where it finds none
std::string certificate_text(const geometry::IndexedMesh& mesh,
                             std::span<const surface::SurfacePoint> points,
                             std::span<const geometry::VertexId> component_vertices,
                             const morskin::PreparedSkin& skin, const certify::Sizing& sizing);

}  // namespace morskin::app
