// Section 2.2, skin/patch.h: a patch's length scale.
//
// rho(x) = 1 / kappa_max. On a sphere it is the radius; on every patch of a skin it is simply the
// distance from the patch's centre. Here the curvature of a neck is measured with a compass: the
// normal turns by an angle over a short distance in each tangent direction.

#include <Eigen/Geometry>

#include "papers/steps/step.h"
#include "skin/skin_surface.h"

int main() {
  using namespace morskin::skin;
  const SkinSurface skin({{{-1, 0, 0}, 2.0}, {{1, 0, 0}, 2.0}});
  bool holds = true;
  for (const double along : {0.0, 0.15, 0.3}) {
    const double across = std::sqrt(0.5 + along * along);  // on the hyperboloid
    const auto p = skin.project(Point(along, across, 0), CellId{});
    if (!p) return 1;
    const Vector first = p->normal.unitOrthogonal(), second = p->normal.cross(first);
    double most = 0;
    for (int i = 0; i < 360; ++i) {
      constexpr double step = 1e-5;
      const double angle = i * M_PI / 360;
      // [excerpt: step-length-scale]
      const Vector t = std::cos(angle) * first + std::sin(angle) * second;
      const auto a = skin.project(p->position - step * t, p->cell);
      const auto b = skin.project(p->position + step * t, p->cell);
      // The part of the turn in the plane of t and the normal: the normal curvature.
      most = std::max(most, std::abs((b->normal - a->normal).dot(t)) / (2 * step));
      // [/excerpt]
    }
    std::printf("x = %.2f: length scale %.6f, 1 / largest curvature measured %.6f\n",
                p->position.x(), p->length_scale, 1 / most);
    holds = holds && std::abs(most * p->length_scale - 1) < 1e-4;
  }
  return step::claim("the distance from the patch's centre is 1 / kappa_max", holds);
}
