// Section 3.1, morse/critical_points.h: the critical points of a torus of balls.
//
// A point is critical for the height along V where the plane tangent to the skin is level, that is
// where the normal is V or -V. The index of a point is the number of directions in which the height
// falls. Whatever V is, minima - saddles + maxima is the skin's Euler characteristic: 0 for a
// torus.

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/predicates.h"
#include "morse/critical_points.h"
#include "papers/steps/step.h"
#include "skin/dual_complex.h"

int main() {
  using namespace morskin;
  std::vector<geometry::WeightedPoint> balls;
  for (int i = 0; i < 12; ++i) {
    const double angle = i * M_PI / 6;
    balls.push_back({{geometry::on_exact_grid(5 * std::cos(angle)),
                      geometry::on_exact_grid(5 * std::sin(angle)), 0},
                     5.12});
  }
  const skin::SkinSurface skin(balls);
  // The balls' dual complex gives the same number without any height.
  const skin::DualComplex dual = skin::dual_complex(skin);
  std::printf("dual complex: genus %zu, Euler characteristic %ld\n", dual.skin_genus(),
              dual.skin_euler_characteristic());
  bool holds = dual.skin_genus() == 1 && dual.skin_euler_characteristic() == 0;
  for (const geometry::Vector& direction :
       {geometry::Vector(0.1, 1, 0.2), geometry::Vector(0.2, 0.1, 1),
        geometry::Vector(1, -0.7, 0.4)}) {
    // [excerpt: step-torus]
    const auto height = morse::MorseFunction::height(direction);
    const auto critical = morse::critical_points(skin, height);
    double steepest = 0;
    for (const morse::CriticalPoint& p : critical.points) {
      steepest = std::max(steepest, p.point.normal.cross(height.direction).norm());
    }
    // [/excerpt]
    std::printf("V along (%.1f, %4.1f, %.1f): %2zu minima - %zu saddles + %2zu maxima = %ld\n",
                direction.x(), direction.y(), direction.z(), critical.count(0), critical.count(1),
                critical.count(2), critical.euler_characteristic());
    holds = holds && critical.degeneracies.empty() && steepest < 1e-12 &&
            critical.euler_characteristic() == dual.skin_euler_characteristic();
  }
  return step::claim("tangent planes are level, and minima - saddles + maxima = 0", holds);
}
