#pragma once

/// The skin surface F of a set of weighted points (section 2.1): where a point lies in the mixed
/// complex, the nearest place on F along the gradient, the length scale and the normal there.

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "geometry/progress.h"
#include "skin/mixed_complex.h"

namespace morskin::skin {

/// A point of the skin with what the mesher asks of it.
struct SurfacePoint {
  Point position;
  Vector normal;        ///< unit, out of the body
  double length_scale;  ///< rho, Angstrom, > 0
  CellId cell;          ///< the mixed cell that contains it
};

class SkinSurface {
 public:
  /// @pre  every coordinate and weight lies on the exact grid (geometry/predicates.h).
  /// @throws geometry::RefusedInput when there is no point with a positive weight.
  /// @param threads  at most; the surface does not depend on it
  explicit SkinSurface(std::vector<WeightedPoint> points, const geometry::Progress& progress = {},
                       MixedComplex::Keep keep = MixedComplex::Keep::NearSkin,
                       unsigned threads = 1);

  const std::vector<WeightedPoint>& points() const { return complex_.points(); }
  const geometry::RegularTriangulation& triangulation() const { return complex_.triangulation(); }
  const MixedComplex& complex() const { return complex_; }
  /// @copydoc MixedComplex::forget_facets
  void forget_facets() { complex_.forget_facets(); }
  Patch patch(CellId cell) const { return complex_.patch(cell); }
  /// Work with the patch of a cell, without a copy of one that is kept.
  template <class Work>
  decltype(auto) with_patch(CellId cell, Work work) const {
    return complex_.is_kept(cell) ? work(complex_.kept_patch(cell)) : work(complex_.patch(cell));
  }
  /// The weighted points whose simplex the cell belongs to, one to four.
  std::vector<AtomId> atoms(CellId cell) const;
  /// Seconds spent in the regular triangulation and in the mixed complex.
  double triangulate_seconds() const { return triangulate_seconds_; }
  double mixed_complex_seconds() const { return mixed_complex_seconds_; }

  /// The mixed cell that contains x, by a walk over cell walls.
  ///
  /// @param start  where the walk begins; the nearer, the shorter.
  /// The mixed complex is a regular subdivision, so a walk that always crosses a wall which x lies
  /// beyond cannot go round. With rounded walls it can, where several cells are flatter than
  /// rounding; when it does, every way is tried.
  CellId locate(const Point& x, CellId start) const;

  /// Whether x lies in a cell that is kept, so that the walk from there ends at once.
  /// @param cell  any number
  bool is_in(const Point& x, CellId cell) const;

  /// G(x), and the cell it was taken in.
  double value(const Point& x, CellId start) const {
    return complex_.patch(locate(x, start)).value(x);
  }

  /// The point of F that x slides to along the gradient, patch by patch.
  ///
  /// @param x      a point less than rho from F
  /// @param start  a cell near x
  /// @return       nothing when the slide does not settle on F to residual_bound(rho).
  std::optional<SurfacePoint> project(const Point& x, CellId start) const;

  /// The point of F at x. @pre x lies on F, in `cell`.
  SurfacePoint at(const Point& x, CellId cell) const;

  /// Largest |G| of a point that project() returns, Angstrom^2: a distance to F of 1e-11 rho and of
  /// the rounding that coordinates of this size cannot avoid.
  double residual_bound(double rho) const {
    return 2 * rho * (1e-11 * rho + 0x1p-9 * complex_.wall_tolerance());
  }

 private:
  template <class Walls>
  CellId next_cell(const Point& x, CellId cell, const Walls& walls) const;
  CellId search(const Point& x, CellId start) const;

  double triangulate_seconds_ = 0;
  double mixed_complex_seconds_ = 0;
  MixedComplex complex_;
};

}  // namespace morskin::skin
