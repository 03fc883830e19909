// The part of DelaunayRefinement that looks at one facet: its surface ball, and whether it must be
// broken.

#include <algorithm>
#include <cmath>

#include "refine/delaunay_refinement.h"

namespace morskin::refine {

using geometry::Triangulator;

DelaunayRefinement::FacetGeometry DelaunayRefinement::geometry_of(Facet f) const {
  FacetGeometry facet;
  const Triangle corners = triangle(f);
  for (std::size_t i = 0; i < 3; ++i) facet.corners[i] = &samples_[corners[i]];
  facet.circle = circumcircle(facet.corners);
  facet.normal = facet.circle.doubled_area.normalized();
  facet.largest = sizing_.C * sizing_.Q * sizing_.scale(min_length_scale(facet.corners));
  return facet;
}

/// The corners of a facet, counter-clockwise seen from outside of its tetrahedron.
DelaunayRefinement::Triangle DelaunayRefinement::triangle(Facet f) const {
  constexpr std::array<std::array<std::size_t, 3>, 4> outward{
      {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
  const auto& corners = delaunay_.tetrahedra()[Triangulator::tetrahedron_of(f)].corners;
  const auto& corner_indices = outward[Triangulator::index_of(f)];
  return {corners[corner_indices[0]], corners[corner_indices[1]], corners[corner_indices[2]]};
}

DelaunayRefinement::Ball DelaunayRefinement::ball_at(const FacetGeometry& facet, double height,
                                                     CellId cell, double slope) const {
  const double r = facet.circle.radius;
  // Both, so that rounding cannot leave a circumradius above its bound.
  const double radius = std::max(r, std::sqrt(r * r + height * height));
  const Point centre = facet.circle.centre + height * facet.normal;
  return {centre, cell, height, radius, radius / facet.largest, slope};
}

/// A crossing of the dual edge from the circumcentre of an inside tetrahedron to that of an outside
/// one, by Newton's steps kept between heights where G is below and above zero.
///
/// G differs from its linear part by at most the square of the distance, so a step of d where the
/// slope is s has a zero within e of its end if s e >= (d + e)^2: within e = 2 d^2 / s if s > 5 d,
/// for (1 + 2 / 5)^2 < 2. If the ball is not asked to be exact, a step after which it is certainly
/// small enough for [U] is the last.
std::optional<DelaunayRefinement::Ball> DelaunayRefinement::ball_of(Facet inner,
                                                                    const FacetGeometry& facet,
                                                                    bool is_exact) const {
  constexpr int max_steps = 100;
  constexpr double short_step = 0.1;
  const Dual& from = duals_[Triangulator::tetrahedron_of(inner)];
  const std::uint32_t outer = Triangulator::tetrahedron_of(behind(inner));
  double low = facet.height(from.centre);
  // Where the line leaves the ball that contains the body it is outside.
  const auto chord = body_.chord(facet.circle.centre, facet.normal);
  if (!chord) return std::nullopt;  // not so where the tetrahedron is inside
  double high = chord->high;
  if (!is_ghost(outer)) high = std::min(high, facet.height(duals_[outer].centre));
  const double radius = facet.circle.radius;
  double height = std::clamp(0.0, std::min(low, high), high);
  CellId cell = facet.corners[0]->cell;
  for (int step = 0; step < max_steps; ++step) {
    const Point x = facet.circle.centre + height * facet.normal;
    cell = surface_.locate(x, cell);
    const auto& [g, n] = surface_.jet(x, cell);
    const double slope = 2 * n.dot(facet.normal);
    if (std::abs(g) <= surface_.residual_bound(n.norm())) {
      return ball_at(facet, height, cell, slope);
    }
    (g < 0 ? low : high) = height;
    double next = height - g / slope;
    const double length = std::abs(next - height);
    if (!(next > low && next < high)) {
      next = low + (high - low) / 2;
    } else if (!is_exact && length < short_step * radius && slope > 5 * length) {
      // N is 1-Lipschitz, and the zero is at most 3/2 d away.
      const Ball ball = ball_at(facet, next, cell, slope - 3 * length);
      if (ball.radius + 2 * length * length / slope < facet.largest) return ball;
    }
    if (next == height) return ball_at(facet, height, cell, slope);
    height = next;
  }
  return std::nullopt;
}

/// A restricted facet's ball, if it is too big for [U], or an angle is too small, or the
/// certificate could not prove the facet.
std::optional<DelaunayRefinement::Ball> DelaunayRefinement::ball_to_break(Facet inner) const {
  const FacetGeometry facet = geometry_of(inner);
  const bool is_thin = has_small_angle(facet);
  std::optional<Ball> ball = ball_of(inner, facet, is_thin);
  if (!ball || ball->ratio >= 1 || is_thin) return ball;
  if (expects_tube(surface_, sizing_, facet.corners)) return std::nullopt;
  ball->keeps_off = true;
  return ball;
}

/// Whether a facet has an angle below the bound.
bool DelaunayRefinement::has_small_angle(const FacetGeometry& facet) const {
  if (min_squared_sine_ == 0) return false;
  const auto& [a, b, c] = facet.corners;
  return smallest_squared_sine(a->position, b->position, c->position) < min_squared_sine_;
}

}  // namespace morskin::refine
