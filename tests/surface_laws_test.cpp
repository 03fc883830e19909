#include "tests/support/surface_laws.h"

#include "skin/level_set.h"
#include "tests/support/formula_surfaces.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::support;

TEST_CASE("a skin obeys the laws of a surface") {
  for_seeds(200, [&](unsigned seed) {
    const skin::SkinSurface skin(ball_set(seed));
    check_surface_laws(skin, seed, 1e-9);
  });
}

TEST_CASE("a level set of growing balls obeys the laws of a surface") {
  for_seeds(100, [&](unsigned seed) {
    const skin::SkinSurface skin(ball_set(seed), skin::MixedComplex::Keep::All);
    check_surface_laws(skin::LevelSet(skin, 0.7), seed, 1e-9);
    check_surface_laws(skin::LevelSet(skin, -0.1), seed, 1e-9);
  });
}

TEST_CASE("a sphere given by a formula obeys the laws of a surface") {
  for_seeds(20, [&](unsigned seed) { check_surface_laws(Sphere(0.3 + seed), seed, 1e-9); });
}

TEST_CASE("a torus given by a formula obeys the laws of a surface") {
  for_seeds(50, [&](unsigned seed) {
    const double r = 0.4 + 0.1 * seed;
    check_surface_laws(Torus((2 + 0.1 * seed) * r, r), seed, 1e-9);
  });
}
