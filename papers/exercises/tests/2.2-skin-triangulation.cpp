#include "answers/2.2-skin-triangulation.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("2.2-skin-triangulation, predict: the numbers of triangles have this ratio, within 10 %" *
          until(times_as_many)) {
  const auto triangles = [](double C) {
    return static_cast<double>(
        meshed("benzene.pdb", support::with({C, 1.65}), skin::Model::Paper).certificate.triangles);
  };
  const double ratio = triangles(0.04) / triangles(0.08);
  judge<double>(times_as_many, [&](double given) { return std::abs(given - ratio) < 0.1 * ratio; },
                {{4, "That were so if edges were proportional to C. Look at R = CQ / (1 + 2CQ)."},
                 {2, "Edges are half as long, or a little more. How many triangles cover an area?"},
                 {8, "A surface has two dimensions, not three."}});
}

TEST_CASE("2.2-skin-triangulation, run: the bound is that of the report" * until(angle_bound_deg)) {
  const certify::Sizing sizing{0.08, 1.73};
  judge<double>(angle_bound_deg,
                [&](double given) { return std::abs(given - sizing.angle_bound_deg()) < 0.006; },
                {{30,
                  "That is what the angles are moved for, not what [L] and [U] promise: mesh with "
                  "--angle-goal 0."},
                 {35,
                  "That is what the angles are moved for, not what [L] and [U] promise: mesh with "
                  "--angle-goal 0."},
                 {certify::Sizing{}.angle_bound_deg(), "That is with the paper's Q."}});
}

TEST_CASE("2.2-skin-triangulation, explain: at this Q an inserted vertex is just far enough" *
          until(smallest_Q)) {
  Cases<double(double)> cases("C");
  for (int i = 1; i < 30; ++i) {
    // The worst case: distance 1, length scales 1/(CQ) and two more; there [L] is an equation.
    const double C = 0.01 * i;
    double low = 1, high = 4;
    while (high - low > 1e-9) {
      const double Q = (low + high) / 2;
      (0.5 > C / Q * (1 / (C * Q) + 2) ? high : low) = Q;
    }
    cases.add(low, C);
  }
  cases.judge(smallest_Q,
              {{[](double) { return std::sqrt(2.0); }, "That is the limit as C goes to zero."},
               {[](double C) { return std::sqrt(2 + 4 * C); },
                "Q stands on both sides of what you have to solve."},
               {[](double C) { return C + std::sqrt(C * C + 2); },
                "The other vertex's length scale may be larger by two distances, not one."},
               {[](double C) { return 4 * C + std::sqrt(16 * C * C + 2); },
                "Half of the factor goes before the root, its square under it."}});
}
