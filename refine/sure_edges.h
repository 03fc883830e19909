#pragma once

/// Edges whose far corners surely lie outside of the surface balls beyond them, told from the
/// angles opposite the edge, before any ball is looked for.
///
/// Let a triangle with circumradius R and the angle alpha opposite an edge meet over that edge a
/// corner d, with the angle beta there, their planes at an angle theta, and let the surface ball's
/// centre be s off the circumcentre. With y the distance of d from the edge,
///
///     |d - centre|^2 - (squared radius)
///         = 2 R y (sin alpha cot beta + cos alpha cos theta - (s / R) sin theta),
///
/// so d lies outside if
///
///     sin alpha (cot alpha + cot beta) > (1 - cos theta) + |s / R| sin theta.
///
/// The right-hand side is below 0.24 for plain triangles: those with R at most 0.2 of the length
/// scale and a normal no farther than asin(0.2) off the skin's, at every corner. Both normals are
/// near the one at a common corner, so sin theta <= 0.392 and 1 - cos theta <= 0.08, and the bound
/// of ball_pencil.h makes |s| at most 0.406 R.

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "refine/triangle_geometry.h"

namespace morskin::refine {

class SureEdges {
 public:
  explicit SureEdges(std::size_t triangles)
      : opposite_(std::make_unique_for_overwrite<Opposite[]>(triangles)) {}

  /// Notes a triangle's angles. To be called once for each, from any thread.
  /// @param most_G  |G| at the corners, Angstrom^2, at most
  void note(TriangleId t, const std::array<const SurfacePoint*, 3>& corners,
            const Circumcircle& circle, double most_G) {
    opposite_[t.index()] = is_plain(corners, circle, most_G)
                               ? cotangents(corners, circle.doubled_area.norm())
                               : Opposite{unknown, unknown, unknown};
  }

  /// Whether neither of the two triangles at an edge can have the other's far corner in its surface
  /// ball; false where the angles do not tell.
  /// @pre both have been noted.
  bool are_sure(HalfEdgeId h, HalfEdgeId twin) const {
    const float here = cotangent(h), there = cotangent(twin), sum = here + there;
    const float flatter = std::max(here * here, there * there);
    return sum > 0 && sum * sum > least * least * (1 + flatter);
  }

 private:
  using Opposite = std::array<float, 3>;  ///< cotangents of the angles opposite the half-edges

  static constexpr float unknown = -std::numeric_limits<float>::infinity();
  static constexpr float least = 0.24F;

  float cotangent(HalfEdgeId h) const { return opposite_[h.index() / 3][h.index() % 3]; }

  static bool is_plain(const std::array<const SurfacePoint*, 3>& corners,
                       const Circumcircle& circle, double most_G) {
    constexpr double largest = 0.2, tilt = 0.2;
    const double least_squared = (1 - tilt * tilt) * circle.doubled_area.squaredNorm();
    for (const SurfacePoint* p : corners) {
      const double upright = p->normal.dot(circle.doubled_area);
      if (!(circle.radius <= largest * p->length_scale && upright > 0 &&
            upright * upright >= least_squared && most_G <= 1e-6 * circle.radius * p->length_scale))
        return false;
    }
    return true;
  }

  static Opposite cotangents(const std::array<const SurfacePoint*, 3>& corners,
                             double doubled_area) {
    const auto& [a, b, c] = corners;
    const Vector ab = b->position - a->position, bc = c->position - b->position;
    const Vector ca = a->position - c->position;
    const double scale = -1 / doubled_area;
    return {static_cast<float>(scale * bc.dot(ca)), static_cast<float>(scale * ca.dot(ab)),
            static_cast<float>(scale * ab.dot(bc))};
  }

  std::unique_ptr<Opposite[]> opposite_;  ///< by triangle
};

}  // namespace morskin::refine
