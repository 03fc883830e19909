#pragma once

/// Improper contact of two triangles, decided exactly.
///
/// In an embedded mesh two triangles meet only in the corners and edges that they share. All other
/// contact is improper: crossing, touching, overlapping.

#include "geometry/exact_positions.h"
#include "geometry/indexed_mesh.h"

namespace morskin::geometry {

/// Whether the closed triangles s and t meet outside the corners and edges they share. Shared
/// corners are the same vertex; equal positions of different vertices are contact. Two triangles
/// with the same three corners are always in improper contact.
///
/// Law: symmetric, and independent of the order of a triangle's corners.
/// @pre neither triangle has its corners on one line.
bool is_improper_contact(const ExactPositions& positions, const TriangleCorners& s,
                         const TriangleCorners& t);

}  // namespace morskin::geometry
