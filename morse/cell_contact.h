#pragma once

/// Whether a whole circle or sphere of critical points, or the stretch of a line within which
/// rounding leaves one, has a place in a mixed cell: only then does it belong to the skin.

#include <optional>
#include <string>

#include "skin/mixed_complex.h"

namespace morskin::morse {

using geometry::Point;
using geometry::Vector;

enum class Where { Inside, Outside, OnWall };

/// Where x lies relative to a cell, `doubt` being the distance within which rounding might decide.
Where side(const skin::MixedComplex& complex, skin::CellId cell, const Point& x, double doubt);

struct Circle {
  Point centre;
  Vector axis;  ///< unit
  double radius;
};

/// A place of the circle in the cell, or within `doubt` of it; nothing if there is none.
std::optional<Point> place_in_cell(const skin::MixedComplex& complex, skin::CellId cell,
                                   const Circle& circle, double doubt);

/// The same for a sphere.
std::optional<Point> place_in_cell(const skin::MixedComplex& complex, skin::CellId cell,
                                   const Point& centre, double radius, double doubt);

/// The same for a stretch of a line, the points start + t direction, from <= t <= to.
///
/// @param to  may be infinite.
struct Stretch {
  Point start;
  Vector direction;
  double from, to;
};
std::optional<Point> place_in_cell(const skin::MixedComplex& complex, skin::CellId cell,
                                   const Stretch& stretch, double doubt);

}  // namespace morskin::morse
