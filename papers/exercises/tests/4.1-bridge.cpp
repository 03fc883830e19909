#include "answers/4.1-bridge.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-bridge, predict: so many bridges are built on a ring" * until(ring_bridges)) {
  const MeshResult ring = meshed("ring12.xyzr", one_front(), skin::Model::Vdw);
  REQUIRE(ring.surviving_points[1] == 2);
  CHECK(*ring_bridges == static_cast<long>(ring.operations.bridge));
}

TEST_CASE("4.1-bridge, run: so many touches lie outside of protecting spheres" *
          until(touches_outside)) {
  const front::Operations counts = meshed("9dna.pdb", one_front()).operations;
  CHECK(*touches_outside == static_cast<long>(counts.guard_outside_protecting));
}

TEST_CASE("4.1-bridge, explain: the level set below a neck's upper saddle has this gap" *
          until(depth_of_gap)) {
  // The waist of a neck of radius rho about the x axis: y^2 + z^2 = rho^2 at x = 0.
  for (const double rho : {0.5, 1.0, 4.0}) {
    for (const double edge : {0.01, 0.02, 0.1}) {
      const double depth = (*depth_of_gap)(rho, edge * rho);
      const double y = rho - depth, gap = 2 * std::sqrt(rho * rho - y * y);
      CHECK(gap == doctest::Approx(edge * rho).epsilon(0.002));
    }
  }
}
