#pragma once

/// The seam between a surface and everything that meshes it or checks a mesh of it.
///
/// A surface F is the zero set of a function G of space, negative inside the body. Space is cut
/// into cells; in each cell G is given by one formula, and a cell's id serves as a hint where to
/// look next. With N = grad G / 2, the laws that front, refinement and certificate rest on:
///
///   1. N is continuous and 1-Lipschitz.
///   2. On F, |N| is the length scale rho. It is 1-Lipschitz, and the balls of radius rho that
///      touch F from either side are free of F.
///   3. project() gives the same point for the same arguments, on F to residual_bound().
///
/// Molecular skins obey them (skin/skin_surface.h), and so does a torus (tests/surface_laws.h).

#include <cmath>
#include <optional>
#include <vector>

#include "surface/bounding_ball.h"
#include "surface/line_crossings.h"
#include "surface/surface_point.h"

namespace morskin::surface {

/// G and N at one place.
struct Jet {
  double value;          ///< G, Angstrom^2
  Vector half_gradient;  ///< N, Angstrom; points out of the body
};

/// Bounds on G and N in a ball about x, from law 1: N differs from `half_gradient` by at most
/// `radius`, and G(p) from G(x) + 2 N(x) . (p - x) by at most |p - x|^2.
struct Enclosure {
  Jet at_centre;
  double radius;  ///< of the ball, Angstrom

  /// |G| is at most this where p - x has a part of at most `along` per unit length along N(x).
  double max_value(double along) const {
    return std::abs(at_centre.value) + (2 * along + radius) * radius;
  }
  /// |N| is at least this; negative where nothing is known.
  double min_half_gradient() const { return at_centre.half_gradient.norm() - radius; }
};

/// How much surface the formula of one cell can describe.
struct PatchExtent {
  double area;              ///< the integral of rho^-2 over it, at most
  double max_length_scale;  ///< on it, Angstrom
};

class Surface {
 public:
  virtual ~Surface();

  /// The cell that contains x. @param hint  where the search begins; the nearer, the shorter
  virtual CellId locate(const Point& x, CellId hint) const = 0;
  /// Whether a hint is right: x lies in that cell. @param cell  any number
  virtual bool is_in(const Point& x, CellId cell) const = 0;

  /// G and N by the formula of a cell, without a search: exact where x lies in it.
  virtual Jet jet(const Point& x, CellId cell) const = 0;
  /// |N| by the formula of a cell, rounded otherwise than jet() would.
  virtual double length_scale(const Point& x, CellId cell) const = 0;

  /// The point of F that x slides to along the gradient.
  /// @param x     less than rho from F
  /// @return      nothing when the slide does not settle on F to residual_bound(rho)
  virtual std::optional<SurfacePoint> project(const Point& x, CellId hint) const = 0;
  /// Largest |G| of a point that project() returns, Angstrom^2.
  virtual double residual_bound(double rho) const = 0;

  /// All crossings of F with the segment from p to q. @pre both ends are finite.
  virtual LineCrossings crossings(const Point& p, const Point& q, CellId hint) const = 0;

  /// A ball that contains the body: beyond it all is outside.
  virtual BoundingBall bounding_ball() const = 0;
  /// Largest length scale on F, at most, Angstrom.
  virtual double max_length_scale() const = 0;
  /// Points spread about as the surface is, to cut work by: the median of a function over them
  /// halves the surface, more or less. At least one.
  virtual std::vector<Point> samples() const = 0;

  /// Cells that F runs through have ids below this.
  virtual std::size_t cell_count() const = 0;
  /// @param max_length_scale  only surface up to it counts @pre cell.index() < cell_count()
  virtual PatchExtent extent(CellId cell, double max_length_scale) const = 0;

  /// The point of F at x. @pre x lies on F, in `cell`.
  SurfacePoint at(const Point& x, CellId cell) const {
    const Vector n = jet(x, cell).half_gradient;
    const double rho = n.norm();
    return {x, n / rho, rho, cell};
  }
  Enclosure enclosure(const Point& x, double radius, CellId cell) const {
    return {jet(x, cell), radius};
  }

 protected:
  Surface() = default;
  Surface(const Surface&) = default;
  Surface(Surface&&) = default;
  Surface& operator=(const Surface&) = default;
  Surface& operator=(Surface&&) = default;
};

}  // namespace morskin::surface
