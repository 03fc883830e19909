#pragma once

/// A view of a surface whose length scales are limited by a size field, so that triangles, which
/// are as large as the length scales, grow slowly from where they have to be small.
///
/// Of the laws of surface.h the length scale's stands in a weaker form, which is all that meshing
/// needs: it is at most |N| and 1-Lipschitz, so that the balls of that radius touch the surface
/// without meeting it. A certificate is of the surface itself.

#include <algorithm>

#include "surface/size_field.h"
#include "surface/surface.h"

namespace morskin::surface {

class GradedSurface final : public Surface {
 public:
  /// @param surface, sizes  must outlive this object
  /// @pre the field's slope is at most 1.
  GradedSurface(const Surface& surface, const SizeField& sizes)
      : surface_(&surface), sizes_(&sizes) {}

  CellId locate(const Point& x, CellId hint) const override { return surface_->locate(x, hint); }
  bool is_in(const Point& x, CellId cell) const override { return surface_->is_in(x, cell); }
  Jet jet(const Point& x, CellId cell) const override { return surface_->jet(x, cell); }
  double length_scale(const Point& x, CellId cell) const override {
    return sizes_->limited(surface_->length_scale(x, cell), x);
  }
  Enclosure enclose(const Point& x, CellId cell) const override {
    return surface_->enclose(x, cell);
  }
  std::optional<SurfacePoint> project(const Point& x, CellId hint) const override {
    std::optional<SurfacePoint> found = surface_->project(x, hint);
    if (found) *found = graded(*found);
    return found;
  }
  double residual_bound(double rho) const override { return surface_->residual_bound(rho); }
  LineCrossings crossings(const Point& p, const Point& q, CellId hint) const override {
    return surface_->crossings(p, q, hint);
  }
  BoundingBall bounding_ball() const override { return surface_->bounding_ball(); }
  double max_length_scale() const override { return surface_->max_length_scale(); }
  /// As many as the surface itself has, by the integral of the limited length scales.
  Samples samples() const override {
    const Samples own = surface_->samples();
    const auto integral = [&](const SurfacePoint& x) {
      const double ratio = x.length_scale / graded(x).length_scale;
      return own.each * ratio * ratio;
    };
    double whole = 0;
    for (const SurfacePoint& x : own.points) whole += integral(x);
    const double count = std::max(1.0, static_cast<double>(own.points.size()));
    Samples result{{}, whole / count};
    double due = 0;
    for (const SurfacePoint& x : own.points) {
      due += integral(x);
      for (; due > result.each / 2; due -= result.each) result.points.push_back(graded(x));
    }
    return result;
  }
  std::size_t cell_count() const override { return surface_->cell_count(); }
  /// Of the surface itself: the integral of its own length scale.
  PatchExtent extent(CellId cell, double max_length_scale) const override {
    return surface_->extent(cell, max_length_scale);
  }

  SurfacePoint at(const Point& x, CellId cell) const override {
    return graded(surface_->at(x, cell));
  }

  /// A point of the surface, with the length scale that counts here.
  SurfacePoint graded(SurfacePoint x) const {
    x.length_scale = sizes_->limited(x.length_scale, x.position);
    return x;
  }

 private:
  const Surface* surface_;
  const SizeField* sizes_;
};

}  // namespace morskin::surface
