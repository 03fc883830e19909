#pragma once

#include <algorithm>
#include <array>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::surface {

using geometry::CellId;
using geometry::Point;
using geometry::Vector;

/// A point of a surface with its first-order data.
struct SurfacePoint {
  Point position;
  Vector normal;        ///< unit, out of the body
  double length_scale;  ///< rho, Angstrom, > 0
  CellId cell;          ///< the cell of the surface that contains it (surface.h)
};

/// The corners of a triangle.
using Corners = std::array<const SurfacePoint*, 3>;

inline double min_length_scale(const Corners& corners) {
  const auto& [a, b, c] = corners;
  return std::min({a->length_scale, b->length_scale, c->length_scale});
}
inline double max_length_scale(const Corners& corners) {
  const auto& [a, b, c] = corners;
  return std::max({a->length_scale, b->length_scale, c->length_scale});
}

}  // namespace morskin::surface
