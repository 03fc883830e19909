#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "surface/mesh.h"
#include "surface/surface.h"

namespace morskin::certify {

using geometry::HalfEdgeId;
using geometry::SurfaceMesh;
using geometry::TriangleId;
using geometry::VertexId;
using surface::Corners;
using surface::Mesh;
using surface::Point;
using surface::SurfacePoint;
using surface::Vector;

/// Circumcentre, circumradius and normal of a triangle in space.
struct Circumcircle {
  Point centre;
  double radius;        ///< Angstrom; huge for a flat triangle
  Vector doubled_area;  ///< (b - a) x (c - a): along the normal, twice the area long
};

inline Circumcircle circumcircle(const Point& a, const Point& b, const Point& c) {
  const Vector e = b - a, f = c - a;
  const Vector n = e.cross(f);
  const double nn = std::max(n.squaredNorm(), 1e-300);
  const Vector offset = (e.squaredNorm() * f.cross(n) + f.squaredNorm() * n.cross(e)) / (2 * nn);
  return {a + offset, offset.norm(), n};
}
inline Circumcircle circumcircle(const Corners& p) {
  return circumcircle(p[0]->position, p[1]->position, p[2]->position);
}

/// Whether a triangle's normal n, of any length, is within 72 degrees of the surface's at each
/// corner.
inline bool is_upright(const Vector& n, const SurfacePoint& a, const SurfacePoint& b,
                       const SurfacePoint& c) {
  const double bound = 0.3 * n.norm();
  return n.dot(a.normal) > bound && n.dot(b.normal) > bound && n.dot(c.normal) > bound;
}

/// The squared sine of a triangle's smallest angle: that edge over the circumcircle's diameter.
inline double smallest_squared_sine(const Point& a, const Point& b, const Point& c) {
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  return (b - a).cross(c - a).squaredNorm() * std::min({ab, bc, ca}) / (ab * bc * ca);
}

/// The smallest and the largest of a triangle's three angles.
struct AngleRange {
  double smallest_deg, largest_deg;
};
inline AngleRange angle_range(const Point& a, const Point& b, const Point& c) {
  const auto angle = [](const Point& at, const Point& p, const Point& q) {
    const Vector e = p - at, f = q - at;
    return std::atan2(e.cross(f).norm(), e.dot(f)) * 180 / M_PI;
  };
  const double at_a = angle(a, b, c), at_b = angle(b, c, a), at_c = angle(c, a, b);
  return {std::min({at_a, at_b, at_c}), std::max({at_a, at_b, at_c})};
}

/// The surface ball of a triangle: centred on the skin, through the three corners. A restricted
/// Delaunay triangle keeps it empty (section 2.2). The centre lies on the line through the
/// circumcentre along the triangle's normal.
struct SurfaceBall {
  Point centre;
  double squared_radius;
  bool is_exact;  ///< whether the centre is on the skin to rounding

  /// Depth of p inside, Angstrom^2: negative outside.
  double intrusion(const Point& p) const { return squared_radius - (p - centre).squaredNorm(); }
};

/// The ball with its centre found by the formula of a's cell alone: off by a few hundredths of the
/// squared radius where the skin changes patches under the triangle.
SurfaceBall quick_surface_ball(const surface::Surface& surface, const SurfacePoint& a,
                               const Circumcircle& circle);
/// The ball with its centre on the surface to rounding, if Newton's method finds one (is_exact).
SurfaceBall exact_surface_ball(const surface::Surface& surface, const SurfacePoint& a,
                               const Point& b, const Point& c);

/// The triangle under x, seen along the normal there: a walk over the mesh that always crosses the
/// edge that x is farthest beyond.
/// @param position   VertexId -> Point
/// @param may_cross  HalfEdgeId -> bool
/// @return nothing where the walk may not cross an edge or takes more than 64 steps, as it may
///         where the mesh is far from the skin
template <class Position, class MayCross>
std::optional<TriangleId> triangle_under(const SurfaceMesh& surface, const Position& position,
                                         TriangleId start, const SurfacePoint& x,
                                         const MayCross& may_cross) {
  constexpr int max_steps = 64;
  TriangleId t = start;
  for (int step = 0; step < max_steps; ++step) {
    double min_side = 0;
    std::optional<HalfEdgeId> through;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(t, k);
      const Point &p = position(surface.origin(h)), &q = position(surface.target(h));
      const double side = (q - p).cross(x.position - p).dot(x.normal);
      if (side >= min_side) continue;
      min_side = side;
      through = h;
    }
    if (!through) return t;
    if (!may_cross(*through)) break;
    t = SurfaceMesh::triangle(surface.twin(*through));
  }
  return std::nullopt;
}

}  // namespace morskin::certify
