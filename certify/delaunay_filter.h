#pragma once

/// A filter for edges that are Delaunay: it proves from the two angles opposite an edge that
/// neither far corner lies in the other triangle's surface ball, without computing a ball.
///
/// Let a triangle have circumradius R and the angle alpha opposite an edge, let d be the far corner
/// of its neighbour there, with the angle beta, and theta the angle between the two planes. Let the
/// surface ball's centre be s off the circumcentre and d at the distance y from the edge. Then
///
///     |d - centre|^2 - (squared radius)
///         = 2 R y (sin alpha cot beta + cos alpha cos theta - (s / R) sin theta),
///
/// so d lies outside if
///
///     sin alpha (cot alpha + cot beta) > (1 - cos theta) + |s / R| sin theta.
///
/// Let x <= 0.2 bound, at every corner of both triangles, R over the length scale and the sine of
/// the angle between the triangle's normal and the skin's. Both normals are near the one at a
/// common corner, so sin theta <= 2 x and 1 - cos theta <= 2 x^2, and by ball_pencil.h
///
///     |s / R| <= 3 x / (m + sqrt(m^2 - 3 x^2)),     m = sqrt(1 - x^2) - x,
///
/// which is at most 2.03 x. The right-hand side is below 6.1 x^2, the clearance.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "certify/triangle_bounds.h"

namespace morskin::certify {

/// The clearance of one triangle, no unit; infinite where the argument does not apply.
/// @param n      its normal, twice its area long
/// @param sides  (2 R |n|)^2, the product of its squared sides
/// @param max_G  bound on |G| at the corners, Angstrom^2
inline double clearance(const Corners& corners, const Vector& n, double sides, double max_G) {
  constexpr double max_x = 0.2, max_residual = 1e-6;
  constexpr double min_clearance = 1e-3;  // above the rounding of stored cotangents
  const auto& [a, b, c] = corners;
  const double n2 = n.squaredNorm();
  const double rho = min_length_scale(corners);
  const double upright = std::min({a->normal.dot(n), b->normal.dot(n), c->normal.dot(n)});
  // x^2 times n^2.
  const double x2n2 = std::max(sides / (4 * rho * rho), n2 - upright * upright);
  if (!(x2n2 <= max_x * max_x * n2 && upright > 0 &&
        4 * max_G * max_G * n2 <= max_residual * max_residual * rho * rho * sides)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(6.1 * x2n2 / n2, min_clearance);
}

/// Whether the filter proves the edge ab of the triangles (a, b, c) and (b, a, d) Delaunay. It
/// avoids roots by (cot alpha + cot beta)^2 >= cot^2 alpha + cot^2 beta, and so proves nothing
/// unless both angles are acute.
/// @param max_G  bound on |G| at the four, Angstrom^2
inline bool is_certainly_delaunay(const Corners& abc, const SurfacePoint& d, double max_G) {
  const auto& [a, b, c] = abc;
  const Vector ab = b->position - a->position;
  const Vector ac = c->position - a->position, bc = c->position - b->position;
  const Vector ad = d.position - a->position, bd = d.position - b->position;
  const double at_c = ac.dot(bc), at_d = ad.dot(bd);
  if (!(at_c > 0 && at_d > 0)) return false;
  const Vector left = ab.cross(ac), right = ad.cross(ab);
  const double squared_ab = ab.squaredNorm();
  const double needed = std::max(
      clearance(abc, left, squared_ab * ac.squaredNorm() * bc.squaredNorm(), max_G),
      clearance({b, a, &d}, right, squared_ab * ad.squaredNorm() * bd.squaredNorm(), max_G));
  // Both cotangents squared, times both squared normals.
  const double l2 = left.squaredNorm(), r2 = right.squaredNorm();
  const double here = at_c * at_c * r2, there = at_d * at_d * l2;
  return here + there > needed * needed * (l2 * r2 + std::max(here, there));
}

/// The filter for all edges of a mesh.
///
/// A triangle takes eight bytes, 16 bits each for its cotangents, rounded down, and its clearance,
/// rounded up. Rounding is safe: where (c + c')^2 > k^2 (1 + max(c, c')^2) with c + c' > 0 and
/// k < 1, c + c' exceeds k max(c, c'), so the difference of the two sides grows with either
/// cotangent; and it falls with k. A cotangent below -8 counts as -8, for which no other makes up.
class DelaunayFilter {
 public:
  explicit DelaunayFilter(std::size_t triangles)
      : opposite_(std::make_unique_for_overwrite<Opposite[]>(triangles)) {}

  /// Stores a triangle's angles. Threads may store different triangles at once.
  /// @param max_G  bound on |G| at the corners, Angstrom^2
  void note(TriangleId t, const Corners& corners, const TriangleSides& triangle, double max_G) {
    const Vector n = triangle.side[0].cross(triangle.side[1]);
    opposite_[t.index()] = {cotangents(triangle, n.norm()),
                            rounded_up(clearance(corners, n, triangle.squared_product(), max_G))};
  }

  void prefetch(HalfEdgeId h) const { geometry::prefetch(&opposite_[h.index() / 3]); }

  /// Whether the filter proves an edge Delaunay. @pre both triangles have been noted.
  bool certainly_delaunay(HalfEdgeId h, HalfEdgeId twin) const {
    const int here = cotangent(h), there = cotangent(twin);
    const auto sum = static_cast<float>(here + there);
    const auto larger = static_cast<float>(std::max(here, there));
    const auto needed = static_cast<float>(std::max(of(h).clearance, of(twin).clearance));
    constexpr auto one = static_cast<float>(cotangent_steps * cotangent_steps);
    constexpr auto in_steps = static_cast<float>(1 / (clearance_steps * clearance_steps));
    return sum > 0 && sum * sum > needed * needed * in_steps * (one + larger * larger);
  }

 private:
  static constexpr double cotangent_steps = 4096, max_cotangent = 8;  ///< steps to 1
  static constexpr double clearance_steps = 1 << 14;
  /// An infinite clearance: above 2, so that no sum exceeds it.
  static constexpr std::uint16_t no_clearance = 0xFFFF;

  struct Opposite {
    std::array<std::int16_t, 3> cotangents;  ///< of the angles opposite the half-edges
    std::uint16_t clearance;
  };

  const Opposite& of(HalfEdgeId h) const { return opposite_[h.index() / 3]; }
  int cotangent(HalfEdgeId h) const { return of(h).cotangents[h.index() % 3]; }

  static std::int16_t rounded_down(double cotangent) {
    constexpr double low = -max_cotangent, high = max_cotangent - 1 / cotangent_steps;
    if (!(cotangent > low)) cotangent = low;  // also NaN, of a degenerate triangle
    const double shifted = (std::min(cotangent, high) + max_cotangent) * cotangent_steps;
    return static_cast<std::int16_t>(static_cast<int>(shifted) -
                                     static_cast<int>(max_cotangent * cotangent_steps));
  }
  static std::uint16_t rounded_up(double clearance) {
    if (!(clearance < 1)) return no_clearance;
    return static_cast<std::uint16_t>(static_cast<int>(clearance * clearance_steps) + 1);
  }

  static std::array<std::int16_t, 3> cotangents(const TriangleSides& triangle,
                                                double doubled_area) {
    const auto& [ab, bc, ca] = triangle.side;
    const double scale = -1 / doubled_area;
    return {rounded_down(scale * bc.dot(ca)), rounded_down(scale * ca.dot(ab)),
            rounded_down(scale * ab.dot(bc))};
  }

  std::unique_ptr<Opposite[]> opposite_;  ///< by triangle
};

}  // namespace morskin::certify
