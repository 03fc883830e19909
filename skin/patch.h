#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/point.h"
#include "surface/surface.h"

namespace morskin::skin {

using geometry::Point;
using geometry::Vector;

/// One quadratic patch of the skin at shrink factor 1/2 (section 2.1): the zero set, inside one
/// mixed cell, of
///
///     G(x) = u . M u - w/2,      u = x - centre,      M = I - 2 P = sign (I - 2 axis axis^T),
///
/// P projecting onto the span of the cell's Delaunay simplex. M is a reflection (M M = I), so the
/// four kinds are one formula:
///
///     simplex       sign   axis                patch
///     vertex         +1    0                   sphere, body inside
///     edge           +1    along the edge      hyperboloid of revolution about the edge
///     triangle       -1    normal to it        hyperboloid of revolution about the normal
///     tetrahedron    -1    0                   sphere, body outside
///
/// G < 0 inside the body; G, its gradient 2 M u and |u| are continuous across cells.
struct Patch {
  Point centre;            ///< the orthocentre: intersection of the simplex's span and its dual's
  Vector axis;             ///< unit, or zero
  double sign = 1;         ///< +1 or -1
  double half_weight = 0;  ///< w/2 of the orthocentre, Angstrom^2; may be negative

  /// M v.
  Vector reflect(const Vector& v) const { return sign * (v - (2 * axis.dot(v)) * axis); }

  // [excerpt: patch]
  /// Half the gradient of G, N = M u. It points out of the body and |N| is the length scale.
  Vector half_gradient(const Point& x) const { return reflect(x - centre); }

  /// G(x), Angstrom^2: negative inside the body, zero on the skin.
  double value(const Point& x) const { return (x - centre).dot(half_gradient(x)) - half_weight; }

  /// Local length scale rho = 1 / kappa_max at a point of the skin (section 2.2), Angstrom.
  double length_scale(const Point& x) const { return (x - centre).norm(); }
  // [/excerpt]

  /// G and N at once.
  surface::Jet jet(const Point& x) const {
    const Vector n = half_gradient(x);
    return {(x - centre).dot(n) - half_weight, n};
  }

  /// Unit normal, out of the body. @pre x is not the centre.
  Vector normal(const Point& x) const { return half_gradient(x).normalized(); }

  /// Moves x along the gradient line to the quadric of this patch. Along x + s N the function is
  /// the parabola G + 2 s |u|^2 + s^2 (G + w/2); s is its nearer root, in the form without
  /// cancellation, or twice Newton's step where there is none.
  Point slide(const Point& x) const {
    const Vector u = x - centre;
    const Vector n = reflect(u);
    const double quadratic = u.dot(n);
    const double g = quadratic - half_weight;
    const double rho_squared = u.squaredNorm();
    const double discriminant = rho_squared * rho_squared - quadratic * g;
    const double s = -g / (rho_squared + std::sqrt(std::max(discriminant, 0.0)));
    return x + s * n;
  }
};

}  // namespace morskin::skin
