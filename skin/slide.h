#pragma once

// Inside skin: the projection that SkinSurface and LevelSet share.

#include <cmath>
#include <optional>

#include "skin/skin_surface.h"

namespace morskin::skin {

/// @param surface  tells the patch of a cell, locates points and bounds the residual
template <class Surface>
std::optional<SurfacePoint> slide_onto(const Surface& surface, const Point& x, CellId start) {
  // Two or three rounds settle a point within rho / 2; the cap is for points that are out of reach.
  constexpr int most_rounds = 40;
  Point y = x;
  CellId cell = surface.locate(y, start);
  for (int round = 0; round < most_rounds; ++round) {
    surface.with_patch(cell, [&](const Patch& patch) { y = patch.slide(y); });
    cell = surface.locate(y, cell);
    Vector n;
    double g = 0;
    surface.with_patch(cell, [&](const Patch& patch) {
      n = patch.half_gradient(y);
      g = (y - patch.centre).dot(n) - patch.half_weight;
    });
    const double rho = n.norm();
    if (std::abs(g) <= surface.residual_bound(rho)) return SurfacePoint{y, n / rho, rho, cell};
  }
  return std::nullopt;
}

}  // namespace morskin::skin
