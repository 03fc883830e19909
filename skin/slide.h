#pragma once

// Inside skin: the projection that SkinSurface and LevelSet share.

#include <cmath>
#include <optional>

#include "skin/skin_surface.h"

namespace morskin::skin {

/// @param skin  has locate(), with_patch(), jet() and residual_bound()
template <class Surface>
std::optional<SurfacePoint> slide_onto(const Surface& skin, const Point& x, CellId hint) {
  // Points within rho / 2 take two or three rounds; the limit is for points too far away.
  constexpr int max_rounds = 40;
  Point y = x;
  CellId cell = skin.locate(y, hint);
  for (int round = 0; round < max_rounds; ++round) {
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
