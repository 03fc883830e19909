#include "refine/circumcentre.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/expansion.h"
#include "geometry/predicates_internal.h"

namespace morskin::refine {

using geometry::Vector;

namespace {

/// The vector from the first corner to the circumcentre: Cramer's rule.
Vector offset_in_106_bits(const std::array<const Point*, 4>& p) {
  using Number = geometry::DoubleDouble;
  std::array<std::array<Number, 3>, 3> e{
      {{Number::difference(p[1]->x(), p[0]->x()), Number::difference(p[1]->y(), p[0]->y()),
        Number::difference(p[1]->z(), p[0]->z())},
       {Number::difference(p[2]->x(), p[0]->x()), Number::difference(p[2]->y(), p[0]->y()),
        Number::difference(p[2]->z(), p[0]->z())},
       {Number::difference(p[3]->x(), p[0]->x()), Number::difference(p[3]->y(), p[0]->y()),
        Number::difference(p[3]->z(), p[0]->z())}}};
  const auto squared = [&](std::size_t i) {
    return e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2];
  };
  const std::array<Number, 3> s{squared(0), squared(1), squared(2)};
  const double twice = 2 * geometry::internal::determinant(e).rounded();
  Vector offset;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto m = e;
    for (std::size_t i = 0; i < 3; ++i) m[i][axis] = s[i];
    offset[static_cast<Eigen::Index>(axis)] = geometry::internal::determinant(m).rounded() / twice;
  }
  return offset;
}

/// In doubles the centre is off by up to some u (L^4 + R L^3) / D, measured, L being the longest
/// edge, R the radius and D the determinant: for R <= L by 2e-6 L where D is this share of L^3.
/// Those that are flatter are computed with 106 bits.
constexpr double flat_share = 1e-10;

}  // namespace

Point circumcentre(const std::array<const Point*, 4>& p) {
  const Vector a = *p[1] - *p[0], b = *p[2] - *p[0], c = *p[3] - *p[0];
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), cc = c.squaredNorm();
  const Vector bc = b.cross(c);
  const double det = a.dot(bc);
  const double longest = std::max({aa, bb, cc});
  if (det * det <= flat_share * flat_share * longest * longest * longest) {
    return *p[0] + offset_in_106_bits(p);
  }
  return *p[0] + (aa * bc + bb * c.cross(a) + cc * a.cross(b)) / (2 * det);
}

}  // namespace morskin::refine
