#pragma once

/// Lower bounds on distances to a triangle, proved after the fact: for any direction y no point of
/// the triangle is nearer to x than its corners are in that direction. With y towards the nearest
/// point the bound is the distance, but for rounding.

#include <array>

#include "certify/triangle_geometry.h"

namespace morskin::certify {

/// The corners of a triangle as seen from a point.
using Offsets = std::array<Vector, 3>;

/// Lower bound on the distance from the origin to the triangle, Angstrom.
double distance_below(const Offsets& corners);

/// Lower bound on the distance from the line through the origin along a unit direction.
double distance_from_line_below(const Offsets& corners, const Vector& direction);

}  // namespace morskin::certify
