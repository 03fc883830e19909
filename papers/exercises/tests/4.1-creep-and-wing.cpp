#include "answers/4.1-creep-and-wing.h"

#include "certify/triangle_geometry.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-creep-and-wing, predict: a ring's mesh has as many triangles for its vertices" *
          until(torus_triangles)) {
  const auto certificate = meshed("ring12.xyzr").certificate;
  REQUIRE(certificate.euler_characteristic == 0);
  const auto is_right = [&](long given) {
    return given * static_cast<long>(certificate.vertices) ==
           5000 * static_cast<long>(certificate.triangles);
  };
  judge<long>(torus_triangles, is_right,
              {{9996, "That is a sphere's, where V - E + F is 2."},
               {15000, "Those are the edges."},
               {5000, "An edge borders on two triangles, and a triangle has three edges."},
               {10004, "V - E + F of a torus is zero."}});
}

TEST_CASE("4.1-creep-and-wing, run: so many corners are winged on 9DNA" * until(wings)) {
  judge_run(wings, meshed("9dna.pdb", one_front()).operations.wing,
            "mesh bench/molecules/9dna.pdb --fronts 1 -o x.ply --json; it is operations.wing");
}

TEST_CASE("4.1-creep-and-wing, explain: the formula is the circumradius of a fan triangle" *
          until(fan_circumradius)) {
  Cases<double(double, double)> cases("r phi");
  for (int i = 1; i < 30; ++i) {
    const double r = 0.7, phi = 0.1 * i;
    const auto circle =
        certify::circumcircle({0, 0, 0}, {r, 0, 0}, {r * std::cos(phi), r * std::sin(phi), 0});
    cases.add(circle.radius, r, phi);
  }
  cases.judge(
      fan_circumradius,
      {{[](double r, double phi) { return r / (2 * std::sin(phi / 2)); },
        "Try phi near 0: the triangle is a needle, its circle not large."},
       {[](double r, double phi) { return r / (2 * std::cos(phi)); },
        "Half the angle: drop the height from the tip."},
       {[](double r, double phi) { return r * std::sin(phi / 2); },
        "That is half of the third side."},
       {[](double r, double phi) { return r / std::cos(phi / 2); }, "That is the diameter."}});
}
