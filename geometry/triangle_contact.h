#pragma once

/// Whether two triangles of a mesh meet where they should not. All answers are exact.
///
/// In an embedded mesh two triangles meet in the corners and edges that they share and nowhere
/// else. Contact beyond that is improper: crossing, touching from outside, lying in one another.

#include <array>
#include <cstdint>

#include "geometry/exact_positions.h"

namespace morskin::geometry {

using Corners = std::array<std::uint32_t, 3>;

/// Whether the triangles s and t, closed sets, meet outside the corners and edges they share.
/// Corners are shared when they are the same vertex; equal positions of different vertices are
/// contact. Two triangles with the same three corners always are in improper contact.
///
/// Law: symmetric, and the same whatever the order of a triangle's corners.
/// @pre neither triangle has its corners on one line.
bool is_improper_contact(const ExactPositions& positions, const Corners& s, const Corners& t);

}  // namespace morskin::geometry
