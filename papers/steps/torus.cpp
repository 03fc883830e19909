// Section 3.1, morse/critical_points.h: the critical points of a torus of balls.
//
// Twelve balls on a circle make a torus. Whatever the direction of the height, minima - saddles +
// maxima is its Euler characteristic, 0; the dual complex of the balls knows that number too.

#include <cmath>

#include "morse/critical_points.h"
#include "papers/steps/step.h"
#include "skin/dual_complex.h"

int main() {
  using namespace morskin;
  std::vector<geometry::WeightedPoint> balls;
  for (int i = 0; i < 12; ++i) {
    const double angle = i * M_PI / 6;
    balls.push_back({{5 * std::cos(angle), 5 * std::sin(angle), 0}, 5.12});
  }
  const skin::SkinSurface skin(balls);
  const skin::DualComplex dual = skin::dual_complex(skin);
  std::printf("dual complex: Euler characteristic %ld, genus %zu\n",
              dual.skin_euler_characteristic(), dual.skin_genus());
  bool holds = dual.skin_euler_characteristic() == 0 && dual.skin_genus() == 1;
  for (const geometry::Vector& v : {geometry::Vector(0.1, 1, 0.2), geometry::Vector(0.2, 0.1, 1),
                                    geometry::Vector(1, -0.7, 0.4)}) {
    const auto critical = morse::critical_points(skin, morse::MorseFunction::height(v));
    std::printf("height along (%.1f, %.1f, %.1f): %zu minima - %zu saddles + %zu maxima = %ld\n",
                v.x(), v.y(), v.z(), critical.count(0), critical.count(1), critical.count(2),
                critical.euler_characteristic());
    holds = holds && critical.degeneracies.empty() && critical.euler_characteristic() == 0;
  }
  return step::claim("minima - saddles + maxima is the Euler characteristic", holds);
}
