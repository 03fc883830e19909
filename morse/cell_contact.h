#pragma once

/// Whether a circle or sphere of critical points, or the piece of a line to which rounding confines
/// one, meets a mixed cell: only then does it belong to the skin.

#include <optional>

#include "skin/mixed_complex.h"

namespace morskin::morse {

using geometry::Point;
using geometry::Vector;

enum class Where { Inside, Outside, OnWall };

/// Where x lies relative to a cell. @param doubt  distance to a wall that counts as on it, Angstrom
Where side(const skin::MixedComplex& complex, skin::CellId cell, const Point& x, double doubt);

struct Circle {
  Point centre;
  Vector axis;  ///< unit
  double radius;
};

/// A point of the circle in the cell, or within `doubt`, Angstrom, of it; nothing if there is none.
std::optional<Point> point_in_cell(const skin::MixedComplex& complex, skin::CellId cell,
                                   const Circle& circle, double doubt);

/// The same for a sphere.
std::optional<Point> point_in_cell(const skin::MixedComplex& complex, skin::CellId cell,
                                   const Point& centre, double radius, double doubt);

/// The same for a piece of a line.
struct Stretch {
  Point start;
  Vector direction;
  double from, to;  ///< the points start + t direction, from <= t <= to; `to` may be infinite
};
std::optional<Point> point_in_cell(const skin::MixedComplex& complex, skin::CellId cell,
                                   const Stretch& stretch, double doubt);

}  // namespace morskin::morse
