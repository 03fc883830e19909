#include "answers/4.1-seal.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-seal, predict: with a cap of 7 triangles this closes to a sphere" *
          until(triangles_of_7_edges)) {
  const long triangles = 7 + *triangles_of_7_edges, vertices = 8;
  CHECK(2 * vertices - triangles == 2 * 2);  // V - 3F/2 + F = 2
}

TEST_CASE("4.1-seal, run: so many maxima are sealed on 9DNA" * until(seals)) {
  CHECK(*seals == static_cast<long>(meshed("9dna.pdb", one_front()).operations.seal));
}

TEST_CASE("4.1-seal, explain: a hole of this size just keeps [U]" * until(largest_hole)) {
  for (const certify::Sizing sizing : {certify::Sizing{}, {0.04, 1.65}, {0.08, 1.8}}) {
    const double rho = 1.3, radius = (*largest_hole)(sizing.C, sizing.Q) * rho / 2;
    CHECK(sizing.triangle_ratio(radius, rho) == doctest::Approx(1));
  }
}
