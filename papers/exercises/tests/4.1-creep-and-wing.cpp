#include "answers/4.1-creep-and-wing.h"

#include "certify/triangle_geometry.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-creep-and-wing, predict: a ring's mesh has as many triangles for its vertices" *
          until(torus_triangles)) {
  const auto certificate = meshed("ring12.xyzr").certificate;
  REQUIRE(certificate.euler_characteristic == 0);
  CHECK(*torus_triangles * static_cast<long>(certificate.vertices) ==
        5000 * static_cast<long>(certificate.triangles));
}

TEST_CASE("4.1-creep-and-wing, run: so many corners are winged on 9DNA" * until(wings)) {
  CHECK(*wings == static_cast<long>(meshed("9dna.pdb", one_front()).operations.wing));
}

TEST_CASE("4.1-creep-and-wing, explain: the formula is the circumradius of a fan triangle" *
          until(fan_circumradius)) {
  for (double phi = 0.1; phi < 3; phi += 0.1) {
    const double r = 0.7;
    const auto circle =
        certify::circumcircle({0, 0, 0}, {r, 0, 0}, {r * std::cos(phi), r * std::sin(phi), 0});
    CHECK((*fan_circumradius)(r, phi) == doctest::Approx(circle.radius));
  }
}
