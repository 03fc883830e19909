#pragma once

/// A second-order triangle, curved through nodes in the middle of its edges: whether it is regular
/// everywhere, proved, and its area. papers/second-order.md derives the bound.

#include <array>
#include <optional>

#include "geometry/point.h"

namespace morskin::certify {

/// The corners a, b, c, then the nodes between a and b, b and c, c and a.
using CurvedTriangle = std::array<geometry::Point, 6>;

/// With x(u, v) the triangle over u, v >= 0, u + v <= 1, and d = (b - a) x (c - a): the least of
/// the six Bernstein coefficients of (x_u x x_v) . d, over |d|^2. It is a lower bound of the
/// Jacobian over that of the flat triangle, 1 for an element that is flat.
/// @return nothing unless every coefficient is proved positive, all rounding counted. If they are,
/// x is an immersion whose normal is everywhere less than 90 degrees from the flat triangle's.
std::optional<double> least_jacobian(const CurvedTriangle& nodes);

/// Its area, Angstrom^2, by a quadrature that is exact for an integrand of degree five.
double curved_area(const CurvedTriangle& nodes);

}  // namespace morskin::certify
