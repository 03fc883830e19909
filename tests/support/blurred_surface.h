#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "surface/surface.h"
#include "tests/support/ball_sets.h"

namespace morskin::support {

using geometry::CellId;
using geometry::Point;
using surface::SurfacePoint;

/// A surface of which no more is known than that N is off by a share of itself at most, and it is.
class Blurred final : public surface::Surface {
 public:
  /// @param aside  -> a unit vector, the way that N is off
  Blurred(const surface::Surface& surface, double share, std::function<geometry::Vector()> aside)
      : surface_(surface), share_(share), aside_(std::move(aside)) {}
  /// What a proof needs to be told.
  Blurred(const surface::Surface& surface, Random& random)
      : Blurred(surface, 0.999 * 0x1p-12, [&random] { return random.direction(); }) {}

  CellId locate(const Point& x, CellId hint) const override { return surface_.locate(x, hint); }
  bool is_in(const Point& x, CellId cell) const override { return surface_.is_in(x, cell); }
  surface::Jet jet(const Point& x, CellId cell) const override { return surface_.jet(x, cell); }
  double length_scale(const Point& x, CellId cell) const override {
    return surface_.length_scale(x, cell);
  }
  surface::Enclosure enclose(const Point& x, CellId cell) const override {
    surface::Enclosure about = surface_.enclose(x, cell);
    const double off = share_ * about.half_gradient.norm() - about.error;
    about.half_gradient += off * aside_();
    about.error += off;
    return about;
  }
  std::optional<SurfacePoint> project(const Point& x, CellId hint) const override {
    return surface_.project(x, hint);
  }
  double residual_bound(double rho) const override { return surface_.residual_bound(rho); }
  surface::LineCrossings crossings(const Point& p, const Point& q, CellId hint) const override {
    return surface_.crossings(p, q, hint);
  }
  surface::BoundingBall bounding_ball() const override { return surface_.bounding_ball(); }
  double max_length_scale() const override { return surface_.max_length_scale(); }
  surface::Samples samples() const override { return surface_.samples(); }
  std::size_t cell_count() const override { return surface_.cell_count(); }
  surface::PatchExtent extent(CellId cell, double max_length_scale) const override {
    return surface_.extent(cell, max_length_scale);
  }

 private:
  const surface::Surface& surface_;
  const double share_;
  const std::function<geometry::Vector()> aside_;
};

}  // namespace morskin::support
