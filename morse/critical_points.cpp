#include "morse/critical_points.h"

#include <Eigen/Geometry>
#include <cmath>

namespace morskin::morse {

namespace {

using skin::CellId;
using skin::Patch;

enum class Where { Inside, Outside, OnWall };

/// Where x lies relative to a cell, `doubt` being the distance within which rounding might decide.
Where side(const skin::MixedComplex& complex, CellId cell, const Point& x, double doubt) {
  Where where = Where::Inside;
  for (const skin::Wall& wall : complex.walls(cell)) {
    const double distance = wall.normal.dot(x) - wall.offset;
    if (distance > doubt) return Where::Outside;
    if (distance > -doubt) where = Where::OnWall;
  }
  return where;
}

CriticalPoint classify(const skin::SkinSurface& surface, CellId cell, const MorseFunction& height,
                       double lambda) {
  const Patch& patch = surface.complex().patch(cell);
  const Vector& v = height.direction;
  const Vector mv = patch.reflect(v);
  CriticalPoint critical;
  const Point x = patch.centre + lambda * mv;
  critical.point = {x, lambda > 0 ? v : Vector(-v), std::abs(lambda), cell};
  critical.value = height(x);
  // M restricted to the tangent plane: `sign` across the axis, `sign * (1 - 2 |a|^2)` along the
  // axis's part a in that plane.
  const Vector along = patch.axis - patch.axis.dot(v) * v;
  const double across_value = -patch.sign / lambda;
  const double along_value = -patch.sign * (1 - 2 * along.squaredNorm()) / lambda;
  critical.index = (across_value < 0) + (along_value < 0);
  if (critical.index == 1) {
    critical.descending = along.normalized();
    critical.ascending = v.cross(along).normalized();
    if (along_value > 0) std::swap(critical.descending, critical.ascending);
  }
  return critical;
}

}  // namespace

std::size_t CriticalPoints::count(int index) const {
  std::size_t n = 0;
  for (const CriticalPoint& p : points) n += p.index == index;
  return n;
}

long CriticalPoints::euler_characteristic() const {
  return static_cast<long>(count(0) + count(2)) - static_cast<long>(count(1));
}

CriticalPoints critical_points(const skin::SkinSurface& surface, const MorseFunction& height) {
  // A point this near a wall, relative to its length scale, may be taken for either side's.
  constexpr double doubt = 1e-9;
  const skin::MixedComplex& complex = surface.complex();
  CriticalPoints result;
  for (std::size_t i = 0; i < complex.size(); ++i) {
    const CellId cell{i};
    const Patch& patch = complex.patch(cell);
    const double axial = patch.axis.dot(height.direction);
    const double d = patch.sign * (1 - 2 * axial * axial);
    if (!(patch.half_weight * d > 0)) continue;
    const double size = std::sqrt(patch.half_weight / d);
    for (const double lambda : {-size, size}) {
      const CriticalPoint critical = classify(surface, cell, height, lambda);
      const Where where =
          side(complex, cell, critical.point.position, doubt * size + complex.wall_tolerance());
      if (where == Where::Outside) continue;
      if (where == Where::OnWall) {
        const Point& x = critical.point.position;
        result.degeneracies.push_back("a critical point lies on a cell wall at (" +
                                      std::to_string(x.x()) + ", " + std::to_string(x.y()) + ", " +
                                      std::to_string(x.z()) + ")");
      }
      result.points.push_back(critical);
    }
  }
  return result;
}

}  // namespace morskin::morse
