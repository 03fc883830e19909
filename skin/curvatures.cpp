#include "skin/curvatures.h"

#include "geometry/orthogonal.h"

namespace morskin::skin {

namespace {

/// The one of v and -v whose largest component is positive.
Vector oriented(const Vector& v) {
  Eigen::Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  return v[largest] < 0 ? Vector(-v) : v;
}

}  // namespace

Curvatures curvatures(const Patch& patch, const surface::SurfacePoint& x) {
  const double cosine = patch.axis.dot(x.normal);
  const double across = patch.sign / patch.length_scale(x.position);
  const double along = patch.axis.isZero(0) ? across : across * (2 * cosine * cosine - 1);
  const Vector direction_along = along == across
                                     ? geometry::TangentFrame(x.normal).first
                                     : geometry::unit_orthogonal_part(patch.axis, x.normal);
  const Vector first =
      oriented(along > across ? direction_along : Vector(x.normal.cross(direction_along)));
  return {{std::max(along, across), std::min(along, across)}, {first, x.normal.cross(first)}};
}

}  // namespace morskin::skin
