#pragma once

/// The seam between a surface and everything that meshes it or checks a mesh of it.
///
/// A surface F is the zero set of a function G of space, negative inside the body. Space is divided
/// into cells with one formula for G in each; a cell's id serves as a hint where a search begins.
/// With N = grad G / 2, the laws that front, refinement and certificate rest on:
///
///   1. N is continuous, and 1-Lipschitz within 2 |N(x)| of each x where enclose() is finite.
///   2. On F, |N| is the length scale rho. It is 1-Lipschitz, and the two open balls of radius rho
///      that touch F at a point, one on each side, do not meet F.
///   3. project() is deterministic and returns points on F to residual_bound().
///   4. enclose() is true in real arithmetic, whatever rounding or cell led to it.
///
/// Molecular skins obey them (skin/skin_surface.h), and so does a torus
/// (tests/support/formula_surfaces.h).

#include <optional>
#include <vector>

#include "surface/bounding_ball.h"
#include "surface/enclosure.h"
#include "surface/line_crossings.h"
#include "surface/surface_point.h"

namespace morskin::surface {

/// G and N at a point.
struct Jet {
  double value;          ///< G, Angstrom^2
  Vector half_gradient;  ///< N, Angstrom; points out of the body
};

/// Bounds on the surface that the formula of one cell can describe.
struct PatchExtent {
  double area;              ///< of the integral of rho^-2
  double max_length_scale;  ///< Angstrom
};

/// Points that stand for a surface.
struct Samples {
  std::vector<SurfacePoint> points;
  double each;  ///< integral of rho^-2 that each stands for
};

class Surface {
 public:
  virtual ~Surface();

  /// The cell that contains x. @param hint  where the search begins; the nearer, the shorter
  virtual CellId locate(const Point& x, CellId hint) const = 0;
  /// Whether x is found in a cell without a search. @param cell  any value, even of no cell
  virtual bool is_in(const Point& x, CellId cell) const = 0;

  /// G and N by the formula of a cell, without a search: exact where x lies in it.
  virtual Jet jet(const Point& x, CellId cell) const = 0;
  /// |N| by the formula of a cell; may differ from that of jet() by rounding.
  virtual double length_scale(const Point& x, CellId cell) const = 0;

  /// Proved bounds on G and N at x, the stored point, all rounding counted.
  /// @param cell  that contains x; with another the bounds are wide, or take longer
  virtual Enclosure enclose(const Point& x, CellId cell) const = 0;

  /// Moves x onto F along the gradient. @pre x is less than rho from F.
  /// @return nothing where this does not converge to residual_bound(rho)
  virtual std::optional<SurfacePoint> project(const Point& x, CellId hint) const = 0;
  /// Bound on |G| at the points that project() returns, Angstrom^2.
  virtual double residual_bound(double rho) const = 0;

  /// All crossings of F with the segment from p to q. @pre both ends are finite.
  virtual LineCrossings crossings(const Point& p, const Point& q, CellId hint) const = 0;

  /// A ball that contains the body.
  virtual BoundingBall bounding_ball() const = 0;
  /// Bound on the length scale on F, Angstrom.
  virtual double max_length_scale() const = 0;
  /// Points of F, drawn the same way every time: as many in a part of it as its share of the whole
  /// integral, roughly. May be none where F is small.
  virtual Samples samples() const = 0;

  /// Cells that F meets have ids below this.
  virtual std::size_t cell_count() const = 0;
  /// @param max_length_scale  only surface with rho up to it counts
  /// @pre cell.index() < cell_count()
  virtual PatchExtent extent(CellId cell, double max_length_scale) const = 0;

  /// x with its normal and length scale. @pre x lies on F, in `cell`.
  virtual SurfacePoint at(const Point& x, CellId cell) const {
    const Vector n = jet(x, cell).half_gradient;
    const double rho = n.norm();
    return {x, n / rho, rho, cell};
  }

 protected:
  Surface() = default;
  Surface(const Surface&) = default;
  Surface(Surface&&) = default;
  Surface& operator=(const Surface&) = default;
  Surface& operator=(Surface&&) = default;
};

}  // namespace morskin::surface
