#pragma once

/// The skin surface F of a set of weighted points (section 2.1): locates points in the mixed
/// complex, projects them onto F along the gradient, and gives length scale and normal.

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "geometry/run.h"
#include "skin/least_power.h"
#include "skin/mixed_complex.h"
#include "skin/skin_samples.h"
#include "surface/surface.h"

namespace morskin::skin {

using surface::BoundingBall;
using surface::Jet;
using surface::LineCrossings;
using surface::PatchExtent;
using surface::SurfacePoint;

/// One to four atoms.
class CellAtoms {
 public:
  template <std::size_t N>
  explicit CellAtoms(const std::array<AtomId, N>& simplex) : size_(N) {
    std::copy(simplex.begin(), simplex.end(), atoms_.begin());
  }
  const AtomId* begin() const { return atoms_.data(); }
  const AtomId* end() const { return begin() + size_; }
  std::size_t size() const { return size_; }

 private:
  std::array<AtomId, 4> atoms_;
  std::size_t size_;
};

class SkinSurface final : public surface::Surface {
 public:
  /// @pre  every coordinate and weight lies on the exact grid (geometry/predicates.h).
  /// @throws geometry::RefusedInput when there is no point with a positive weight.
  /// In two stages, "triangulate" and "mixed complex".
  explicit SkinSurface(std::vector<WeightedPoint> points,
                       MixedComplex::Keep keep = MixedComplex::Keep::NearSkin,
                       const geometry::Run& run = geometry::Run());

  const std::vector<WeightedPoint>& points() const { return complex_.points(); }
  const geometry::RegularTriangulation& triangulation() const { return complex_.triangulation(); }
  const MixedComplex& complex() const { return complex_; }
  /// @copydoc MixedComplex::forget_facets
  void forget_facets() { complex_.forget_facets(); }
  Patch patch(CellId cell) const { return complex_.patch(cell); }
  /// Calls work(patch) with the patch of a cell, without copying that of a kept cell.
  template <class Work>
  decltype(auto) with_patch(CellId cell, Work work) const {
    return complex_.is_kept(cell) ? work(complex_.kept_patch(cell)) : work(complex_.patch(cell));
  }
  /// The corners of the cell's simplex.
  CellAtoms atoms(CellId cell) const;

  /// The atom of the least power distance to x; of equals the one with the lowest id.
  /// @param cell  that contains x
  AtomId nearest_atom(const Point& x, CellId cell) const;

  /// The mixed cell that contains x, by a walk over cell walls.
  ///
  /// It crosses the wall that x is farthest beyond. The mixed complex need not be a regular
  /// subdivision: over just any wall with x beyond it a walk may cycle. Over the farthest it does
  /// where several cells are flatter than rounding; then a search tries every path. On two walls or
  /// more of a cell, which may be flat, it goes by the definition whether the cell contains x; if
  /// not, the walk begins anew at the nearest atom.
  CellId locate(const Point& x, CellId hint) const override;
  /// Whether `cell` is a kept cell and contains x, so that a walk from it ends at once.
  bool is_in(const Point& x, CellId cell) const override;
  /// The last t up to which p + t d is by definition in `cell`, within whose walls it is from
  /// `from` to `to`: a cell without volume may have no wall where it ends.
  double last_in(CellId cell, const Point& p, const Vector& d, double from, double to) const;

  Jet jet(const Point& x, CellId cell) const override {
    return with_patch(cell, [&](const Patch& patch) { return patch.jet(x); });
  }
  double length_scale(const Point& x, CellId cell) const override {
    return with_patch(cell, [&](const Patch& patch) { return patch.length_scale(x); });
  }
  /// G(x).
  double value(const Point& x, CellId hint) const {
    return complex_.patch(locate(x, hint)).value(x);
  }

  /// @copydoc skin::enclose
  surface::Enclosure enclose(const Point& x, CellId cell) const override;

  /// Slides patch by patch (Patch::slide).
  std::optional<SurfacePoint> project(const Point& x, CellId hint) const override;
  /// For a distance to F of 1e-11 rho and the rounding of coordinates of this size.
  double residual_bound(double rho) const override {
    return 2 * rho * (1e-11 * rho + 0x1p-9 * complex_.wall_tolerance());
  }
  /// @copydoc line_crossings
  LineCrossings crossings(const Point& p, const Point& q, CellId hint) const override;

  BoundingBall bounding_ball() const override;
  double max_length_scale() const override;
  /// @copydoc skin_samples
  surface::Samples samples() const override { return skin_samples(*this, complex_); }
  std::size_t cell_count() const override { return complex_.kept_size(); }
  PatchExtent extent(CellId cell, double max_length_scale) const override;

 private:
  struct Step {
    CellId next;      ///< the cell itself where x is within all its walls
    bool is_on_wall;  ///< so, but for rounding
  };
  template <class Walls>
  Step step_over(const Point& x, CellId cell, const Walls& walls) const;
  /// A plane where the dual of a cell's simplex ends.
  struct DualEnd {
    Vector normal;    ///< unit, out of the dual; zero where a point is past no such plane
    double distance;  ///< of the point past the plane, Angstrom
  };
  DualEnd end_of_dual(const Point& q, CellId cell) const;
  /// Moving x over a wall moves the dual's point twice as far.
  double dual_tolerance() const {
    constexpr double of_flat_simplices = 64;
    return 2 * of_flat_simplices * complex_.wall_tolerance();
  }
  bool is_by_definition_in(const Point& x, CellId cell) const;
  CellId search(const Point& x, CellId start) const;

  MixedComplex complex_;
  LeastPower powers_;
};

/// Of a hyperboloid's waist, or half the distance of its sheets. A cone has neither; it counts as
/// if it had too narrow a one to tell.
double waist_radius(const Patch& patch, double max_length_scale);
/// Bounds on the surface that a patch can describe, up to a length scale.
PatchExtent extent_of(const Patch& patch, double max_length_scale);

}  // namespace morskin::skin
