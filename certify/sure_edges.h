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
/// Let x be at least R over the length scale and the sine of the angle between the triangle's
/// normal and the skin's, at every corner of both triangles, and at most 0.2. Both normals are near
/// the one at a common corner, so sin theta <= 2 x and 1 - cos theta <= 2 x^2, and the bound of
/// ball_pencil.h is
///
///     |s / R| <= 3 x / (m + sqrt(m^2 - 3 x^2)),     m = sqrt(1 - x^2) - x,
///
/// which is x times something that grows with x to 2.03 at 0.2. The right-hand side stays below
/// 6.1 x^2, the clearance.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "certify/triangle_geometry.h"

namespace morskin::certify {

/// The clearance that a triangle asks for by itself; infinite where there is no bound.
/// @param n       its normal, twice its area long
/// @param sides   (2 R |n|)^2, the product of its squared sides
/// @param most_G  |G| at the corners, Angstrom^2, at most
inline double clearance(const std::array<const SurfacePoint*, 3>& corners, const Vector& n,
                        double sides, double most_G) {
  // The least is above the rounding of cotangents when they are noted.
  constexpr double largest = 0.2, residual = 1e-6, least = 1e-3;
  const auto& [a, b, c] = corners;
  const double n2 = n.squaredNorm();
  const double rho = std::min({a->length_scale, b->length_scale, c->length_scale});
  const double upright = std::min({a->normal.dot(n), b->normal.dot(n), c->normal.dot(n)});
  // x^2 times n^2.
  const double x2n2 = std::max(sides / (4 * rho * rho), n2 - upright * upright);
  if (!(x2n2 <= largest * largest * n2 && upright > 0 &&
        4 * most_G * most_G * n2 <= residual * residual * rho * rho * sides)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(6.1 * x2n2 / n2, least);
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
  const double needed = std::max(
      clearance(abc, left, squared_ab * ac.squaredNorm() * bc.squaredNorm(), most_G),
      clearance({b, a, &d}, right, squared_ab * ad.squaredNorm() * bd.squaredNorm(), most_G));
  // Both cotangents squared, times both squared normals.
  const double l2 = left.squaredNorm(), r2 = right.squaredNorm();
  const double here = at_c * at_c * r2, there = at_d * at_d * l2;
  return here + there > needed * needed * (l2 * r2 + std::max(here, there));
}

/// The same for the edges of a mesh, from cotangents noted for each triangle.
///
/// They are noted to 16 bits, so that a triangle takes eight bytes: cotangents rounded down, the
/// clearance up. Where (c + c')^2 > k^2 (1 + max(c, c')^2) with c + c' > 0, k < 1, the left-hand
/// side less the right grows with either cotangent and falls with k, so what the rounded ones tell
/// the true ones would tell too. A cotangent below -8 counts as -8: no other makes up for it.
class SureEdges {
 public:
  explicit SureEdges(std::size_t triangles)
      : opposite_(std::make_unique_for_overwrite<Opposite[]>(triangles)) {}

  /// Notes a triangle's angles. To be called once for each, from any thread.
  /// @param most_G  |G| at the corners, Angstrom^2, at most
  void note(TriangleId t, const std::array<const SurfacePoint*, 3>& corners,
            const Circumcircle& circle, double most_G) {
    const Vector& n = circle.doubled_area;
    const double squared_area = n.squaredNorm();
    const double sides = 4 * circle.radius * circle.radius * squared_area;
    opposite_[t.index()] = {cotangents(corners, std::sqrt(squared_area)),
                            rounded_up(clearance(corners, n, sides, most_G))};
  }

  /// Asks for what are_sure() will look at.
  void prefetch(HalfEdgeId h) const { geometry::prefetch(&opposite_[h.index() / 3]); }

  /// Whether neither of the two triangles at an edge can have the other's far corner in its surface
  /// ball; false where the angles do not tell.
  /// @pre both have been noted.
  bool are_sure(HalfEdgeId h, HalfEdgeId twin) const {
    const int here = cotangent(h), there = cotangent(twin);
    const auto sum = static_cast<float>(here + there);
    const auto larger = static_cast<float>(std::max(here, there));
    const auto needed = static_cast<float>(std::max(of(h).clearance, of(twin).clearance));
    constexpr auto one = static_cast<float>(cotangent_steps * cotangent_steps);
    constexpr auto in_steps = static_cast<float>(1 / (clearance_steps * clearance_steps));
    return sum > 0 && sum * sum > needed * needed * in_steps * (one + larger * larger);
  }

 private:
  static constexpr double cotangent_steps = 4096, most_cotangent = 8;  ///< steps to 1
  static constexpr double clearance_steps = 1 << 14;
  /// For none. As it is above 2, no sum is larger.
  static constexpr std::uint16_t no_clearance = 0xFFFF;

  struct Opposite {
    std::array<std::int16_t, 3> cotangents;  ///< of the angles opposite the half-edges
    std::uint16_t clearance;
  };

  const Opposite& of(HalfEdgeId h) const { return opposite_[h.index() / 3]; }
  int cotangent(HalfEdgeId h) const { return of(h).cotangents[h.index() % 3]; }

  static std::int16_t rounded_down(double cotangent) {
    constexpr double least = -most_cotangent, most = most_cotangent - 1 / cotangent_steps;
    if (!(cotangent > least)) cotangent = least;  // or not a number, of no triangle
    const double shifted = (std::min(cotangent, most) + most_cotangent) * cotangent_steps;
    return static_cast<std::int16_t>(static_cast<int>(shifted) -
                                     static_cast<int>(most_cotangent * cotangent_steps));
  }
  static std::uint16_t rounded_up(double clearance) {
    if (!(clearance < 1)) return no_clearance;
    return static_cast<std::uint16_t>(static_cast<int>(clearance * clearance_steps) + 1);
  }

  static std::array<std::int16_t, 3> cotangents(const std::array<const SurfacePoint*, 3>& corners,
                                                double doubled_area) {
    const auto& [a, b, c] = corners;
    const Vector ab = b->position - a->position, bc = c->position - b->position;
    const Vector ca = a->position - c->position;
    const double scale = -1 / doubled_area;
    return {rounded_down(scale * bc.dot(ca)), rounded_down(scale * ca.dot(ab)),
            rounded_down(scale * ab.dot(bc))};
  }

  std::unique_ptr<Opposite[]> opposite_;  ///< by triangle
};

}  // namespace morskin::certify
