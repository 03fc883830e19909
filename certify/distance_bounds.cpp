#include "certify/distance_bounds.h"

#include <algorithm>

namespace morskin::certify {

namespace {

/// The share of the longest offset by which a product of an offset and a unit vector may be off:
/// each offset was rounded once, the product five times, the length of y thrice.
constexpr double rounding = 0x1p-48;

Vector nearest_on_edge(const Vector& p, const Vector& q) {
  const Vector e = q - p;
  const double squared = e.squaredNorm();
  return squared > 0 ? Vector(p + std::clamp(-p.dot(e) / squared, 0.0, 1.0) * e) : p;
}

/// The point of the triangle nearest to the origin, to rounding.
Vector nearest_in_triangle(const Offsets& corner) {
  const auto& [a, b, c] = corner;
  const Vector n = (b - a).cross(c - a);
  Vector nearest = a;
  bool is_over = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector &p = corner[k], &q = corner[(k + 1) % 3];
    is_over = is_over && (q - p).cross(-p).dot(n) >= 0;
    const Vector on_edge = nearest_on_edge(p, q);
    if (on_edge.squaredNorm() < nearest.squaredNorm()) nearest = on_edge;
  }
  const double squared_area = n.squaredNorm();
  return is_over && squared_area > 0 ? Vector(n * (n.dot(a) / squared_area)) : nearest;
}

/// The least y . corner, rounded down, with y as long as one.
double least_along(const Offsets& corners, const Vector& y) {
  const double length = y.norm();
  if (!(length > 0)) return 0;
  double least = y.dot(corners[0]), longest = 0;
  for (const Vector& corner : corners) {
    least = std::min(least, y.dot(corner));
    longest = std::max(longest, corner.norm());
  }
  return std::max(0.0, least / length - rounding * longest);
}

}  // namespace

double distance_below(const Offsets& corners) {
  return least_along(corners, nearest_in_triangle(corners));
}

double distance_from_line_below(const Offsets& corners, const Vector& direction) {
  Offsets across;
  for (std::size_t k = 0; k < 3; ++k) {
    across[k] = corners[k] - corners[k].dot(direction) * direction;
  }
  const Vector y = nearest_in_triangle(across);
  // A point p lies y . p / |y| from the line but for the part of y along it.
  double longest = 0;
  for (const Vector& corner : corners) longest = std::max(longest, corner.norm());
  const double lean = std::abs(y.dot(direction)) / y.norm() + rounding;
  return std::max(0.0, least_along(corners, y) - 2 * lean * longest);
}

}  // namespace morskin::certify
