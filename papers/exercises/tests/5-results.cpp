#include "answers/5-results.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("5-results, predict: so many seconds, with as many triangles in each, within 1 s" *
          until(linear_seconds)) {
  const double triangles_per_second = 24336.0 / 5;
  CHECK(std::abs(*linear_seconds - 305186 / triangles_per_second) < 1);
}

TEST_CASE("5-results, run: the smallest angle of 9DNA from one front, unsmoothed" *
          until(smallest_angle_deg)) {
  const double smallest = meshed("9dna.pdb", {.sizing = {}, .angle_goal_deg = 0, .fronts = 1})
                              .certificate.min_angle_deg;
  CHECK(std::abs(*smallest_angle_deg - smallest) < 0.01);
}

TEST_CASE("5-results, explain: the power is that of the law the times follow" * until(power)) {
  for (double p = 0.5; p < 3; p += 0.25) {
    for (const double n : {10.0, 1e3, 1e6}) {
      const double k = 1e-6, m = 7 * n;
      CHECK((*power)(n, k * std::pow(n, p), m, k * std::pow(m, p)) == doctest::Approx(p));
    }
  }
  CHECK((*power)(24336, 5, 305186, 202) == doctest::Approx(1.46).epsilon(0.005));
}
