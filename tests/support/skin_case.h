#pragma once

#include "skin/skin_surface.h"
#include "tests/support/test.h"

namespace morskin::support {

using namespace skin;

/// Rounding, relative to the span of the coordinates: of a length, and of G with the span squared.
constexpr double rounding = 1e-10;

/// The skin of a random ball set, and points about it.
struct SkinCase {
  explicit SkinCase(unsigned seed)
      : random(seed + 1000000),
        skin(support::ball_set(seed)),
        box(support::box_of(skin.points())),
        span(support::span_of(box)) {}

  CellId cell_of(const Point& x) const { return skin.locate(x, CellId{0U}); }
  double value(const Point& x) const { return skin.value(x, CellId{0U}); }
  Vector half_gradient(const Point& x) const {
    return skin.complex().patch(cell_of(x)).half_gradient(x);
  }
  double length_rounding() const { return rounding * span; }
  double value_rounding() const { return rounding * span * span; }
  /// A point of the skin, or nothing when the random point chosen does not reach it.
  std::optional<SurfacePoint> surface_point() {
    const Point x = box.sample(random);
    return skin.project(x, cell_of(x));
  }

  Random random;
  SkinSurface skin;
  support::Box box;
  double span;
};

/// Tries a law at so many points of the box of each of 300 skins.
template <class Law>
void for_points(int count, Law law) {
  for_seeds<SkinCase>(300, [&](SkinCase& test) {
    for (int i = 0; i < count; ++i) law(test, test.box.sample(test.random));
  });
}
/// The same at points of the skin, as many as are met.
template <class Law>
void for_surface_points(int count, Law law) {
  for_seeds<SkinCase>(300, [&](SkinCase& test) {
    for (int i = 0; i < count; ++i) {
      if (const auto p = test.surface_point()) law(test, *p);
    }
  });
}

/// How far outside a cell x lies, Angstrom; negative inside.
inline double outside(const MixedComplex& complex, CellId cell, const Point& x) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Wall& wall : complex.walls(cell)) {
    farthest = std::max(farthest, wall.normal.dot(x) - wall.offset);
  }
  return farthest;
}

}  // namespace morskin::support
