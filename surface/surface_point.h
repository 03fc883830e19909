#pragma once

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::surface {

using geometry::CellId;
using geometry::Point;
using geometry::Vector;

/// A point of a surface with what the mesher asks of it.
struct SurfacePoint {
  Point position;
  Vector normal;        ///< unit, out of the body
  double length_scale;  ///< rho, Angstrom, > 0
  CellId cell;          ///< the cell of the surface that contains it (surface.h)
};

}  // namespace morskin::surface
