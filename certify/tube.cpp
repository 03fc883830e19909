#include "certify/tube.h"

#include <cmath>
#include <limits>

namespace morskin::certify {

namespace {

using surface::CellId;
using surface::Enclosure;

/// At most 4^5 pieces, so that a triangle that fails costs no more than meshing a few others.
constexpr int max_depth = 5;

/// Margin of the comparisons below, in shares of |N|: far above the rounding of the few operations
/// that lead to either side, 2^-48 together.
constexpr double margin_of_proof = 1e-6;

/// A mesher's, who takes N as if it were exact: a proof then succeeds whose N is off by 2^-12 of
/// itself (skin/enclosure.cpp), an error e. It lowers |N|^2 by 2 e min|N| and raises the bound on
/// |G| by 2 e r. Where (c2) is near, r < min|N|, so |N| < 2 min|N|, and both make 2^-9 min|N|^2.
constexpr double margin_of_mesher = 0x1p-9;

/// (c1) and (c2) on a triangle's pieces.
/// @tparam Enclose  (point, cell) -> Enclosure
template <class Enclose>
class Pieces {
 public:
  /// @param max_G  on all of the triangle
  Pieces(const Enclose& enclose, const TriangleBounds& triangle, double max_G, double off_plane,
         double margin)
      : enclose_(enclose),
        triangle_(triangle),
        max_G_(max_G),
        off_plane_(off_plane),
        margin_(margin) {}

  /// Whether both hold on all of a piece.
  ///
  /// At points no farther than r from its centroid x, N . n_t is at least N(x) . n_t - r, |N| at
  /// least |N(x)| - r, and |G| at most |G(x)| + 2 t r + r^2, t the part of N(x) along the triangle,
  /// by |G(p) - G(x) - 2 N(x) . (p - x)| <= |p - x|^2. The stored corners and x are off the exact
  /// pieces, and off the triangle's plane, by no more than `off_plane`.
  bool hold(const std::array<Point, 3>& p, CellId cell, int depth) {
    const Point x = (p[0] + p[1] + p[2]) / 3;
    const double r =
        off_plane_ + std::sqrt(std::max({(p[0] - x).squaredNorm(), (p[1] - x).squaredNorm(),
                                         (p[2] - x).squaredNorm()}));
    const Enclosure about = enclose_(x, cell);
    const Vector& N = about.half_gradient;
    const double size = N.norm(), upright = N.dot(triangle_.normal);
    const double max_G = about.max_value(), error = about.error;
    // The centroid itself breaks a condition.
    if (!(upright > 0)) return fail(proof_.is_upright);
    if (!(max_G < size * size)) return fail(proof_.is_in_tube);
    const double tilt = size * triangle_.normal_error;
    const double along = std::sqrt(std::max(0.0, size * size - upright * upright)) + tilt + error;
    const double value = std::min(max_G_, max_G + 2 * (along * r + size * off_plane_) + r * r);
    const double min_N = size - error - r;
    const bool is_upright = upright - tilt - error - r > margin_ * size;
    const bool is_in_tube = min_N > 0 && value < (1 - margin_) * min_N * min_N;
    if (is_upright && is_in_tube) {
      proof_.max_path = std::max(proof_.max_path, max_flow_path(min_N, value));
      return true;
    }
    if (depth == max_depth) return fail(is_upright ? proof_.is_in_tube : proof_.is_upright);
    const std::array<Point, 3> m{(p[1] + p[2]) / 2, (p[2] + p[0]) / 2, (p[0] + p[1]) / 2};
    return hold({p[0], m[2], m[1]}, cell, depth + 1) && hold({p[1], m[0], m[2]}, cell, depth + 1) &&
           hold({p[2], m[1], m[0]}, cell, depth + 1) && hold(m, cell, depth + 1);
  }

  const TubeProof& proof() const { return proof_; }

 private:
  static bool fail(bool& condition) { return condition = false; }

  const Enclose& enclose_;
  const TriangleBounds& triangle_;
  const double max_G_;
  const double off_plane_;
  const double margin_;
  TubeProof proof_{true, true, 0};
};

/// The proof with any way to enclose G and N at a point.
template <class Enclose>
TubeProof prove(const Enclose& enclose, const Corners& corners, const TriangleBounds& triangle,
                const CornerBounds& bounds, double margin) {
  const TriangleSides& sides = triangle.sides;
  const std::size_t k = sides.top();
  const SurfacePoint& a = *corners[k];
  const double longer_side = std::sqrt(std::max(sides.squared[k], sides.squared[(k + 2) % 3]));
  const double R = triangle.circumradius;
  const double upright = a.length_scale * a.normal.dot(triangle.normal);  // N(a) . n_t
  const double doubt = a.length_scale * (triangle.normal_error + margin) + bounds.max_error;
  const double rho = min_length_scale(corners) - bounds.max_error;
  const double g = R * R + bounds.max_value;
  // Nothing is in the tube without a bound on its path.
  const double path = max_flow_path((1 - margin) * (rho - R), g);
  const TubeProof quick{upright - doubt > longer_side, std::isfinite(path), path};
  // Upside down at a corner, or too big for the tube of a ball, where |G| = R^2 and
  // |N|^2 = rho^2 - R^2 at the circumcentre.
  const bool is_hopeless = !(upright > 0) || !(R < rho);
  if (quick.holds() || is_hopeless) return quick;
  // Each halving and the centroid round a coordinate by 2^-53 of itself, in six steps.
  double largest = 0;
  for (const SurfacePoint* p : corners) largest = std::max(largest, p->position.lpNorm<1>());
  const double off_plane = 0x1p-49 * largest;
  Pieces<Enclose> pieces(enclose, triangle, g, off_plane, margin);
  const bool holds =
      pieces.hold({corners[0]->position, corners[1]->position, corners[2]->position}, a.cell, 0);
  TubeProof proof = pieces.proof();
  if (!holds) proof.max_path = std::numeric_limits<double>::infinity();
  return proof;
}

}  // namespace

double max_flow_path(double n, double g) {
  constexpr double up = 1 + 0x1p-48;
  const double square = n * n - g - 0x1p-50 * n * n;  // of |N| at the path's end, at least
  return n > 0 && square > 0 ? up * g / (n + std::sqrt(square))
                             : std::numeric_limits<double>::infinity();
}

TubeProof prove_tube(const surface::Surface& surface, const Corners& corners,
                     const TriangleBounds& triangle, const CornerBounds& bounds) {
  const auto enclose = [&](const Point& x, CellId cell) { return surface.enclose(x, cell); };
  return prove(enclose, corners, triangle, bounds, margin_of_proof);
}

bool expects_tube(const surface::Surface& surface, const Corners& corners,
                  const Circumcircle& circle, double max_G) {
  CellId near = corners[0]->cell;  // of the last point: pieces come side by side
  const auto expect = [&](const Point& x, CellId) {
    near = surface.locate(x, near);
    const surface::Jet jet = surface.jet(x, near);
    return Enclosure::without_rounding(jet.value, jet.half_gradient);
  };
  const TriangleBounds triangle{TriangleSides(corners), circle.radius,
                                circle.doubled_area.normalized(), 0};
  return prove(expect, corners, triangle, {max_G, 0}, margin_of_mesher).holds();
}

}  // namespace morskin::certify
