#include "answers/2.2-skin-triangulation.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("2.2-skin-triangulation, predict: the numbers of triangles have this ratio, within 10 %" *
          until(times_as_many)) {
  const auto triangles = [](double C) {
    return static_cast<double>(
        meshed("benzene.pdb", support::with({C, 1.65})).certificate.triangles);
  };
  CHECK(triangles(0.04) / triangles(0.08) == doctest::Approx(*times_as_many).epsilon(0.1));
}

TEST_CASE("2.2-skin-triangulation, run: the bound is arcsin(1/Q^2)" * until(angle_bound_deg)) {
  const certify::Sizing sizing{0.08, 1.6};
  CHECK(std::abs(*angle_bound_deg - sizing.angle_bound_deg()) < 0.01);
}

TEST_CASE("2.2-skin-triangulation, explain: at this Q an inserted vertex is just far enough" *
          until(smallest_Q)) {
  for (double C = 0.01; C < 0.3; C += 0.01) {
    CAPTURE(C);
    const double Q = (*smallest_Q)(C);
    // The worst case: distance 1, length scales 1/(CQ) and two more.
    CHECK(0.5 == doctest::Approx(C / Q * (1 / (C * Q) + 2)));
  }
}
