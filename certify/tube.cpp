#include "certify/tube.h"

#include <cmath>
#include <limits>
#include <utility>

namespace morskin::certify {

namespace {

using surface::CellId;
using surface::Enclosure;

/// At most 4^5 pieces, so that a triangle that fails costs no more than meshing a few others.
constexpr int max_depth = 5;

/// Margin of the comparisons below, in shares of |N|: far above the rounding of the few operations
/// that lead to either side, 2^-48 together.
constexpr double margin = 1e-6;

/// What a mesher takes N's error to be, in shares of |N|: a proof then succeeds whose N is off by
/// 2^-12 of itself (skin/enclosure.cpp), for it counts that much once more.
constexpr double error_of_mesher = 0x1p-11;

/// A corner of a piece, and what is known of G and N there.
struct Seen {
  Seen(const Point& point, CellId around, const Enclosure& about)
      : x(point),
        cell(around),
        N(about.half_gradient),
        size(N.norm()),
        max_G(about.max_value()),
        error(about.error) {}

  Point x;
  CellId cell;  ///< that contains x
  Vector N;
  double size;   ///< of N
  double max_G;  ///< of its magnitude
  double error;  ///< of N
};

/// The point midway, and its cell: the two points' own if they share one, for cells are convex.
std::pair<Point, CellId> middle(const surface::Surface& surface, const Seen& a, const Seen& b) {
  const Point x = (a.x + b.x) / 2;
  return {x, a.cell == b.cell ? a.cell : surface.locate(x, a.cell)};
}

/// (c1) and (c2) on a triangle's pieces.
/// @tparam Look  (corner, corner) -> Seen, of the point midway between
template <class Look>
class Pieces {
 public:
  /// @param off  bound on the distance of the pieces' corners, as stored, from the exact ones
  Pieces(const Look& look, const TriangleBounds& triangle, double off)
      : look_(look), triangle_(triangle), off_(off) {}

  /// Whether both hold on all of a piece with at most the circumradius R, by what holds of its
  /// corners. The affine function with N's values there differs from N by no more than `bend`, for
  /// N is an isometry in each cell (Lemma 9 of papers/certificate.md).
  bool hold(const std::array<const Seen*, 3>& corners, double R, int depth) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double min_upright = infinity, min_N = infinity, max_G = 0, doubt = 0, fold = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Seen &at = *corners[k], &next = *corners[k == 2 ? 0 : k + 1];
      const double upright = at.N.dot(triangle_.normal);
      // The corner itself breaks a condition.
      if (!(upright > 0)) return fail(proof_.is_upright);
      if (!(at.max_G < at.size * at.size)) return fail(proof_.is_in_tube);
      min_upright = std::min(min_upright, upright - (triangle_.normal_error + margin) * at.size);
      min_N = std::min(min_N, at.size);
      max_G = std::max(max_G, at.max_G + (2 * (at.size + at.error) + off_) * off_);
      doubt = std::max(doubt, at.error);
      fold = std::max(fold, (next.x - at.x).squaredNorm() - (next.N - at.N).squaredNorm());
    }
    doubt += off_ + 0x1p-50 * R;
    const double bend = std::min(R, std::sqrt((fold + 16 * doubt * (R + doubt)) / 3));
    const double at_corners = std::max(0.0, min_N - doubt);
    const double affine = std::sqrt(std::max(0.0, at_corners * at_corners - R * R));
    const bool is_upright = min_upright - doubt > bend;
    const double path = max_flow_path((1 - margin) * affine - bend, max_G + R * R);
    if (is_upright && std::isfinite(path)) {
      proof_.max_path = std::max(proof_.max_path, path);
      return true;
    }
    if (depth == max_depth) return fail(is_upright ? proof_.is_in_tube : proof_.is_upright);
    const auto& [a, b, c] = corners;
    const Seen bc = look_(*b, *c), ca = look_(*c, *a), ab = look_(*a, *b);
    return hold({&bc, &ca, &ab}, R / 2, depth + 1) && hold({a, &ab, &ca}, R / 2, depth + 1) &&
           hold({b, &bc, &ab}, R / 2, depth + 1) && hold({c, &ca, &bc}, R / 2, depth + 1);
  }

  const TubeProof& proof() const { return proof_; }

 private:
  static bool fail(bool& condition) { return condition = false; }

  const Look& look_;
  const TriangleBounds& triangle_;
  const double off_;
  TubeProof proof_{true, true, 0};
};

/// What the corner opposite the longest side shows, for fine triangles.
TubeProof prove_quickly(const Corners& corners, const TriangleBounds& triangle,
                        const CornerBounds& bounds) {
  const TriangleSides& sides = triangle.sides;
  const std::size_t k = sides.top();
  const SurfacePoint& a = *corners[k];
  const double longer_side = std::sqrt(std::max(sides.squared[k], sides.squared[(k + 2) % 3]));
  const double R = triangle.circumradius;
  const double upright = a.length_scale * a.normal.dot(triangle.normal);  // N(a) . n_t
  const double doubt = a.length_scale * (triangle.normal_error + margin) + bounds.max_error;
  const double rho = min_length_scale(corners) - bounds.max_error;
  // Nothing is in the tube without a bound on its path.
  const double path = max_flow_path((1 - margin) * (rho - R), R * R + bounds.max_value());
  return {upright - doubt > longer_side, std::isfinite(path), path};
}

/// Not worth cutting up: no triangle on a ball is so big, where |N|^2 = rho^2 - R^2 at the
/// circumcentre.
bool is_hopeless(const Corners& corners, double R) { return !(R < min_length_scale(corners)); }

/// The proof by pieces.
template <class Look>
TubeProof prove_by_pieces(const Look& look, const std::array<Seen, 3>& corners,
                          const TriangleBounds& triangle) {
  double largest = 0;
  for (const Seen& at : corners) largest = std::max(largest, at.x.template lpNorm<1>());
  // Each of up to five halvings rounds a coordinate by 2^-53 of itself.
  Pieces<Look> pieces(look, triangle, 0x1p-49 * largest);
  const bool holds = pieces.hold({&corners[0], &corners[1], &corners[2]}, triangle.circumradius, 0);
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
  const TubeProof quick = prove_quickly(corners, triangle, bounds);
  if (quick.holds() || is_hopeless(corners, triangle.circumradius)) return quick;
  const auto at = [&](std::size_t k) {
    const auto& [x, normal, rho, cell] = *corners[k];
    const double g = bounds.max_values[k];
    return Seen(x, cell, {-g, g, rho * normal, bounds.max_error});
  };
  const auto look = [&](const Seen& a, const Seen& b) {
    const auto [x, cell] = middle(surface, a, b);
    return Seen(x, cell, surface.enclose(x, cell));
  };
  return prove_by_pieces(look, {at(0), at(1), at(2)}, triangle);
}

bool expects_tube(const surface::Surface& surface, const Corners& corners) {
  const Circumcircle circle = circumcircle(corners);
  const TriangleBounds triangle{TriangleSides(corners), circle.radius,
                                circle.doubled_area.normalized(), 0};
  const double largest = max_length_scale(corners), max_error = error_of_mesher * largest;
  const double max_G = surface.residual_bound(largest);
  if (prove_quickly(corners, triangle, {{max_G, max_G, max_G}, max_error}).holds()) return true;
  if (is_hopeless(corners, circle.radius)) return false;
  const auto see = [&](const Point& x, CellId cell) {
    const auto& [g, N] = surface.jet(x, cell);
    return Seen(x, cell, {g, g, N, error_of_mesher * N.norm()});
  };
  const auto look = [&](const Seen& a, const Seen& b) {
    const auto [x, cell] = middle(surface, a, b);
    return see(x, cell);
  };
  // Not length scale times normal, for a size field may limit length scales.
  const auto at = [&](std::size_t k) { return see(corners[k]->position, corners[k]->cell); };
  return prove_by_pieces(look, {at(0), at(1), at(2)}, triangle).holds();
}

}  // namespace morskin::certify
