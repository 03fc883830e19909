#pragma once

// Inside skin: the projection that SkinSurface and LevelSet share.

#include <cmath>
#include <optional>

#include "skin/skin_surface.h"

namespace morskin::skin {

/// @param skin  tells the patch of a cell, locates points and bounds the residual
template <class Surface>
std::optional<SurfacePoint> slide_onto(const Surface& skin, const Point& x, CellId hint) {
  // Two or three rounds settle a point within rho / 2; the cap is for points that are out of reach.
  constexpr int most_rounds = 40;
  Point y = x;
  CellId cell = skin.locate(y, hint);
  for (int round = 0; round < most_rounds; ++round) {
    skin.with_patch(cell, [&](const Patch& patch) { y = patch.slide(y); });
    cell = skin.locate(y, cell);
    const surface::Jet jet = skin.jet(y, cell);
    const double rho = jet.half_gradient.norm();
    if (std::abs(jet.value) <= skin.residual_bound(rho)) {
      return SurfacePoint{y, jet.half_gradient / rho, rho, cell};
    }
  }
  return std::nullopt;
}

}  // namespace morskin::skin
