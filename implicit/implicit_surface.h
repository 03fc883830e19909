#pragma once

/// The zero set of a function as a surface for front, refinement and certificate.
///
/// Let g be the levelled function (hessian_bound.h), which has the same zeros and the same gradient
/// there, and M a proved bound on the norm of its Hessian in a room about the zero set (room.h).
/// With
///
///     G = 2 g / M,   N = grad G / 2 = grad g / M
///
/// the laws of surface.h hold. The room holds a ball of radius 3 |N(x)| about each zero x. In it N
/// is 1-Lipschitz, so |N| is too, and by Taylor's theorem |G(x + d) - 2 N(x) . d| <= |d|^2, so that
/// G keeps its sign in the open balls of radius |N(x)| that touch the surface at x. Of two zeros
/// farther apart than 3 |N| of either no law speaks but that |N| is 1-Lipschitz, which is plain
/// then. All is one cell.

#include <algorithm>
#include <memory>

#include "implicit/critical_heights.h"
#include "implicit/hessian_bound.h"
#include "implicit/room.h"
#include "surface/surface.h"

namespace morskin::implicit {

using surface::CellId;

class ImplicitSurface final : public surface::Surface {
 public:
  /// @param room  Room(cover, M); outside of it nothing is known of the surface
  /// @param M     bounds the Hessian of the levelled f in it
  /// @pre the zero set in `room` is what `cover` covers
  ImplicitSurface(std::shared_ptr<const Function> f, Cover cover, const Levelling& levelling,
                  Room room, double M);

  CellId locate(const Point&, CellId) const override { return CellId{0U}; }
  bool is_in(const Point&, CellId cell) const override { return cell == CellId{0U}; }
  surface::Jet jet(const Point& x, CellId cell) const override;
  double length_scale(const Point& x, CellId cell) const override {
    return jet(x, cell).half_gradient.norm();
  }
  /// Infinite where x and what the certificate concludes from it are not all in the room.
  surface::Enclosure enclose(const Point& x, CellId cell) const override;
  /// By steps that never pass the surface. Where |G| < |N|^2 at x, the tube of the certificate, it
  /// is proved to arrive: see project().
  std::optional<surface::SurfacePoint> project(const Point& x, CellId hint) const override;
  double residual_bound(double rho) const override {
    return std::max(relative_residual * rho * rho + error_, 2 * rho * rounding_);
  }
  surface::LineCrossings crossings(const Point& p, const Point& q, CellId hint) const override;
  surface::BoundingBall bounding_ball() const override { return body_; }
  double max_length_scale() const override { return max_length_scale_; }
  surface::Samples samples() const override;
  std::size_t cell_count() const override { return 1; }
  surface::PatchExtent extent(CellId, double) const override {
    return {max_integral_, max_length_scale_};
  }

  const Function& function() const { return *f_; }
  const Cover& cover() const { return cover_; }
  double hessian_bound() const { return M_; }
  const Room& room() const { return room_; }

 private:
  static constexpr double relative_residual = 1e-11;

  void halve(const Point& p, const Point& q, double low, double high,
             surface::LineCrossings& found) const;
  surface::LineCrossing zero(const Point& p, const Point& q, double low, double high,
                             bool is_outside_at_low) const;

  std::shared_ptr<const Function> f_;
  Cover cover_;
  Levelling levelling_;
  Room room_;
  surface::BoundingBall body_;
  double M_;
  double max_length_scale_;
  double max_integral_ = 0;  ///< bound on that of rho^-2
  double error_ = 0;         ///< four times the largest rounding of G that was met, Angstrom^2
  double rounding_ = 0;      ///< of coordinates, four units of their size, Angstrom
};

/// The function of the seam, its topology's proof, and the part of space that they speak of.
struct PreparedSurface {
  ImplicitSurface surface;
  CriticalHeights critical;
  Box searched;  ///< whether f has zeros outside is not known
};

/// The part of space that a surface is searched in.
struct SearchSpace {
  Box cube;               ///< its half a power of two, its centre on a coarse grid
  bool is_fixed = false;  ///< else it is doubled until the surface lies in it with room
};

/// Covers the zero set, bounds the Hessian round it and finds the critical points of a height.
/// Stages "cover", "second derivatives", "critical points".
/// @param height  the direction asked for; without one the default, and others where that leaves a
///                box undecided
/// @throws SingularLevel
/// @throws geometry::RefusedInput  where there is no zero, the space holds it not with room, or
///                                 bounds on f or its derivatives tell nothing
PreparedSurface prepare_surface(std::shared_ptr<const Function> f, const SearchSpace& space,
                                const std::optional<Vector>& height,
                                const geometry::Run& run = geometry::Run());

}  // namespace morskin::implicit
