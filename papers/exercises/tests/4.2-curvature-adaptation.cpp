#include "answers/4.2-curvature-adaptation.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.2-curvature-adaptation, predict: a lone ball has so many triangles, within 20 %" *
          until(triangles_on_a_ball)) {
  const auto result = support::meshed({support::ball(0, 0, 0, 1)});
  CHECK(static_cast<double>(result.certificate.triangles) ==
        doctest::Approx(*triangles_on_a_ball).epsilon(0.2));
}

TEST_CASE("4.2-curvature-adaptation, run: with half the C benzene has so many triangles" *
          until(benzene_triangles)) {
  CHECK(
      *benzene_triangles ==
      static_cast<long>(meshed("benzene.pdb", support::with({0.04, 1.65})).certificate.triangles));
}

TEST_CASE("4.2-curvature-adaptation, explain: the closed form is the derivation's, for all C, Q" *
          until(disk_share)) {
  for (double C = 0.01; C < 0.2; C += 0.01) {
    for (double Q = 1.42; Q < 2; Q += 0.05) {
      CHECK((*disk_share)(C, Q) == doctest::Approx(certify::Sizing{C, Q}.tangent_disk_share()));
    }
  }
}
