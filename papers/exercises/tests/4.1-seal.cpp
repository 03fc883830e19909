#include "answers/4.1-seal.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-seal, predict: with a cap of 7 triangles this closes to a sphere" *
          until(triangles_of_7_edges)) {
  const auto is_right = [](long given) {
    const long triangles = 7 + given, vertices = 8;
    return 2 * vertices - triangles == 2 * 2;  // V - 3F/2 + F = 2
  };
  judge<long>(triangles_of_7_edges, is_right,
              {{7, "That is a fan about a new vertex."},
               {6, "The last triangle closes three edges at once."},
               {3, "A triangle on two neighbouring edges leaves one in their place."},
               {4, "Count the edges that are left after each triangle: one fewer."}});
}

TEST_CASE("4.1-seal, run: so many maxima are sealed on a protein of a virus" * until(seals)) {
  judge_run(
      seals, meshed("2buk.pdb.gz", one_front(0.18)).operations.seal,
      "mesh bench/molecules/2buk.pdb.gz -C 0.18 --fronts 1 -o x.ply --json; it is operations.seal");
}

TEST_CASE("4.1-seal, explain: a hole of this size just keeps [U]" * until(largest_hole)) {
  Cases<double(double, double)> cases("C Q");
  for (const certify::Sizing sizing : {certify::Sizing{}, {0.04, 1.65}, {0.08, 1.8}}) {
    // The largest radius for which [U] holds, by halving.
    double low = 0, high = 1;
    while (high - low > 1e-9) {
      const double radius = (low + high) / 2;
      (sizing.triangle_ratio(radius, 1) < 1 ? low : high) = radius;
    }
    cases.add_within(1e-7, 2 * low, sizing.C, sizing.Q);
  }
  cases.judge(
      largest_hole,
      {{[](double C, double Q) { return C * Q; }, "That is the radius."},
       {[](double C, double Q) { return 2 * C / Q; }, "That is [L], for edges."},
       {[](double C, double Q) { return 2 * C * Q / (1 + 2 * C * Q); },
        "Nothing moves here: rho is the same all over the hole."},
       {[](double C, double Q) { return std::sqrt(3.0) * C * Q; },
        "That is the edge of an equilateral triangle; the hole is as wide as its circle."}});
}
