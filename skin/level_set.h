#pragma once

/// The skin of growing balls: at time t every weight is w + t (Angstrom^2). The regular
/// triangulation, the mixed complex and all orthocentres stay as they are, and every orthocentre's
/// weight becomes w + t; so the skin at t is the level set G = t / 2 of the one function whose zero
/// set is the skin at t = 0 (papers/5-dynamic.md).
///
/// A LevelSet is a view of a SkinSurface at such a time, with the same questions.

#include <optional>

#include "skin/skin_surface.h"

namespace morskin::skin {

class LevelSet {
 public:
  /// @param skin  must outlive this object
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
  CellId locate(const Point& x, CellId start) const { return skin_->locate(x, start); }
  double residual_bound(double rho) const { return skin_->residual_bound(rho); }
  /// As SkinSurface::project, onto the level set.
  std::optional<SurfacePoint> project(const Point& x, CellId start) const;
  SurfacePoint at(const Point& x, CellId cell) const { return skin_->at(x, cell); }

 private:
  const SkinSurface* skin_;
  double half_time_;
};

}  // namespace morskin::skin
