#include "certify/tube.h"

#include <limits>

namespace morskin::certify {

namespace {

/// At most 4^5 pieces, so that a triangle that fails costs no more than meshing a few others.
constexpr int max_depth = 5;

/// Margin of the bounds, in shares of |N|: far above the rounding of G and N, some 1e-15 of the
/// molecule's extent.
constexpr double margin = 1e-6;

/// (c1) and (c2) on a triangle's pieces.
class Pieces {
 public:
  /// @param max_G  on all of the triangle
  Pieces(const surface::Surface& surface, const Vector& normal, double max_G)
      : surface_(surface), normal_(normal), max_G_(max_G) {}

  /// Whether both hold on all of a piece.
  ///
  /// At points no farther than r from its centroid x, N . n_t is at least N(x) . n_t - r, |N| at
  /// least |N(x)| - r, and |G| at most |G(x)| + 2 t r + r^2, t the part of N(x) along the triangle,
  /// by |G(p) - G(x) - 2 N(x) . (p - x)| <= |p - x|^2.
  bool hold(const std::array<Point, 3>& p, surface::CellId cell, int depth) {
    const Point x = (p[0] + p[1] + p[2]) / 3;
    const double r = std::sqrt(
        std::max({(p[0] - x).squaredNorm(), (p[1] - x).squaredNorm(), (p[2] - x).squaredNorm()}));
    cell = surface_.locate(x, cell);
    const surface::Enclosure about = surface_.enclosure(x, r, cell);
    const Vector& N = about.at_centre.half_gradient;
    const double G = std::abs(about.at_centre.value);
    const double size = N.norm(), upright = N.dot(normal_);
    // The centroid itself breaks a condition.
    if (!(upright > 0)) return fail(proof_.is_upright);
    if (!(G < size * size)) return fail(proof_.is_in_tube);
    const double along = std::sqrt(std::max(0.0, size * size - upright * upright));
    const double max_G = std::min(max_G_, about.max_value(along));
    const double min_N = about.min_half_gradient();
    const bool is_upright = upright - r > margin * size;
    const bool is_in_tube = min_N > 0 && max_G < (1 - margin) * min_N * min_N;
    if (is_upright && is_in_tube) {
      proof_.max_path = std::max(proof_.max_path, max_flow_path(min_N, max_G));
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

  const surface::Surface& surface_;
  const Vector normal_;
  const double max_G_;
  TubeProof proof_{true, true, 0};
};

}  // namespace

double max_flow_path(double n, double g) {
  return n * n > g ? g / (n + std::sqrt(n * n - g)) : std::numeric_limits<double>::infinity();
}

TubeProof prove_tube(const surface::Surface& surface, const Corners& corners,
                     const Circumcircle& circle, double max_G) {
  std::array<double, 3> squared;  // of the side opposite corner k
  for (std::size_t k = 0; k < 3; ++k) {
    squared[k] = (corners[(k + 1) % 3]->position - corners[(k + 2) % 3]->position).squaredNorm();
  }
  const auto k =
      static_cast<std::size_t>(std::max_element(squared.begin(), squared.end()) - squared.begin());
  const double longer_side = std::max(squared[(k + 1) % 3], squared[(k + 2) % 3]);  // squared
  const double squared_area = circle.doubled_area.squaredNorm();
  // N(a) . n_t, times twice the area.
  const double upright = corners[k]->length_scale * corners[k]->normal.dot(circle.doubled_area);
  const bool is_upright = upright > 0 && upright * upright > longer_side * squared_area;
  const double rho = min_length_scale(corners);
  const double g = circle.radius * circle.radius + max_G;
  const double n = rho - circle.radius;
  const TubeProof quick{is_upright, n > 0 && g < n * n, max_flow_path(n, g)};
  // Upside down at a corner, or too big for the tube of a ball, where |G| = R^2 and
  // |N|^2 = rho^2 - R^2 at the circumcentre.
  const bool is_hopeless = !(upright > 0) || !(circle.radius < rho);
  if (quick.holds() || is_hopeless) return quick;
  Pieces pieces(surface, circle.doubled_area / std::sqrt(squared_area), g);
  const bool holds = pieces.hold({corners[0]->position, corners[1]->position, corners[2]->position},
                                 corners[0]->cell, 0);
  TubeProof proof = pieces.proof();
  if (!holds) proof.max_path = std::numeric_limits<double>::infinity();
  return proof;
}

}  // namespace morskin::certify
