#pragma once

/// The skin of growing balls: at time t every weight is w + t (Angstrom^2). The regular
/// triangulation, the mixed complex and all orthocentres do not change, and every orthocentre's
/// weight becomes w + t; so the skin at t is the level set G = t / 2 of the function G whose zero
/// set is the skin at t = 0 (papers/5-dynamic.md). A LevelSet is a view of a SkinSurface at time t.

#include "skin/skin_surface.h"

namespace morskin::skin {

class LevelSet final : public surface::Surface {
 public:
  /// @param skin  must outlive this object, with all cells kept
  /// @param time  Angstrom^2 added to every weight
  LevelSet(const SkinSurface& skin, double time) : skin_(&skin), half_time_(time / 2) {}

  const MixedComplex& complex() const { return skin_->complex(); }
  Patch patch(CellId cell) const {
    Patch raised = skin_->complex().patch(cell);
    raised.half_weight += half_time_;
    return raised;
  }
  template <class Work>
  decltype(auto) with_patch(CellId cell, Work work) const {
    return work(patch(cell));
  }

  CellId locate(const Point& x, CellId hint) const override { return skin_->locate(x, hint); }
  bool is_in(const Point& x, CellId cell) const override { return skin_->is_in(x, cell); }
  /// @copydoc SkinSurface::last_in
  double last_in(CellId cell, const Point& p, const Vector& d, double from, double to) const {
    return skin_->last_in(cell, p, d, from, to);
  }
  Jet jet(const Point& x, CellId cell) const override { return patch(cell).jet(x); }
  double length_scale(const Point& x, CellId cell) const override {
    return skin_->length_scale(x, cell);
  }
  surface::Enclosure enclose(const Point& x, CellId cell) const override;
  std::optional<SurfacePoint> project(const Point& x, CellId hint) const override;
  double residual_bound(double rho) const override { return skin_->residual_bound(rho); }
  LineCrossings crossings(const Point& p, const Point& q, CellId hint) const override;
  BoundingBall bounding_ball() const override;
  double max_length_scale() const override;
  /// Those of the skin, projected.
  surface::Samples samples() const override;
  std::size_t cell_count() const override { return skin_->cell_count(); }
  PatchExtent extent(CellId cell, double max_length_scale) const override;

 private:
  const SkinSurface* skin_;
  double half_time_;
};

}  // namespace morskin::skin
