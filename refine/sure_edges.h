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

/// The bound for plain triangles.
inline constexpr double least_clearance = 0.24;

/// Whether a triangle is plain.
/// @param n       its normal, twice its area long
/// @param sides   (2 R |n|)^2, the product of its squared sides
/// @param most_G  |G| at the corners, Angstrom^2, at most
inline bool is_plain(const std::array<const SurfacePoint*, 3>& corners, const Vector& n,
                     double sides, double most_G) {
  constexpr double largest = 0.2, tilt = 0.2, residual = 1e-6;
  const double n2 = n.squaredNorm();
  for (const SurfacePoint* p : corners) {
    const double upright = p->normal.dot(n), rho2 = p->length_scale * p->length_scale;
    if (!(sides <= 4 * largest * largest * rho2 * n2 && upright > 0 &&
          upright * upright >= (1 - tilt * tilt) * n2 &&
          4 * most_G * most_G * n2 <= residual * residual * rho2 * sides)) {
      return false;
    }
  }
  return true;
}

/// Whether neither of the triangles (a, b, c) and (b, a, d) can have the other's far corner in its
/// surface ball: told without a root for acute angles opposite ab, as mostly, by
/// (cot alpha + cot beta)^2 >= cot^2 alpha + cot^2 beta; false where that does not tell.
/// @param most_G  |G| at the four, Angstrom^2, at most
inline bool is_surely_delaunay(const std::array<const SurfacePoint*, 3>& abc, const SurfacePoint& d,
                               double most_G) {
  const auto& [a, b, c] = abc;
  const Vector ab = b->position - a->position;
  const Vector ac = c->position - a->position, bc = c->position - b->position;
  const Vector ad = d.position - a->position, bd = d.position - b->position;
  const double at_c = ac.dot(bc), at_d = ad.dot(bd);
  if (!(at_c > 0 && at_d > 0)) return false;
  const Vector left = ab.cross(ac), right = ad.cross(ab);
  const double squared_ab = ab.squaredNorm();
  if (!is_plain(abc, left, squared_ab * ac.squaredNorm() * bc.squaredNorm(), most_G) ||
      !is_plain({b, a, &d}, right, squared_ab * ad.squaredNorm() * bd.squaredNorm(), most_G)) {
    return false;
  }
  // Both cotangents squared, times both squared normals.
  const double l2 = left.squaredNorm(), r2 = right.squaredNorm();
  const double here = at_c * at_c * r2, there = at_d * at_d * l2;
  return here + there > least_clearance * least_clearance * (l2 * r2 + std::max(here, there));
}

/// The same for the edges of a mesh, from cotangents noted for each triangle.
class SureEdges {
 public:
  explicit SureEdges(std::size_t triangles)
      : opposite_(std::make_unique_for_overwrite<Opposite[]>(triangles)) {}

  /// Notes a triangle's angles. To be called once for each, from any thread.
  /// @param most_G  |G| at the corners, Angstrom^2, at most
  void note(TriangleId t, const std::array<const SurfacePoint*, 3>& corners,
            const Circumcircle& circle, double most_G) {
    const Vector& n = circle.doubled_area;
    const double sides = 4 * circle.radius * circle.radius * n.squaredNorm();
    opposite_[t.index()] = is_plain(corners, n, sides, most_G)
                               ? cotangents(corners, n.norm())
                               : Opposite{unknown, unknown, unknown};
  }

  /// Asks for what are_sure() will look at.
  void prefetch(HalfEdgeId h) const { geometry::prefetch(&opposite_[h.index() / 3]); }

  /// Whether neither of the two triangles at an edge can have the other's far corner in its surface
  /// ball; false where the angles do not tell.
  /// @pre both have been noted.
  bool are_sure(HalfEdgeId h, HalfEdgeId twin) const {
    const float here = cotangent(h), there = cotangent(twin), sum = here + there;
    const float flatter = std::max(here * here, there * there);
    constexpr auto least = static_cast<float>(least_clearance);
    return sum > 0 && sum * sum > least * least * (1 + flatter);
  }

 private:
  using Opposite = std::array<float, 3>;  ///< cotangents of the angles opposite the half-edges

  static constexpr float unknown = -std::numeric_limits<float>::infinity();

  float cotangent(HalfEdgeId h) const { return opposite_[h.index() / 3][h.index() % 3]; }

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
