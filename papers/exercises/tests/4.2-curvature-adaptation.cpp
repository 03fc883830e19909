#include "answers/4.2-curvature-adaptation.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.2-curvature-adaptation, predict: a lone ball has so many triangles, within 20 %" *
          until(triangles_on_a_ball)) {
  const auto result = support::meshed({support::ball(0, 0, 0, 1)});
  const double triangles = static_cast<double>(result.certificate.triangles);
  judge<double>(
      triangles_on_a_ball,
      [&](double given) { return std::abs(given - triangles) < 0.2 * triangles; },
      {{4 * M_PI / (0.75 * std::sqrt(3.0) * 0.181 * 0.181),
        "0.181 is the edge here, not the circumradius."},
       {4 * M_PI / (0.181 * 0.181), "That is the area of a square."},
       {M_PI / (std::sqrt(3.0) / 4 * 0.181 * 0.181), "That is the area of a disk, not of a ball."},
       {4 * M_PI / (std::sqrt(3.0) / 2 * 0.181 * 0.181),
        "That is the area of two triangles, a rhombus."}});
}

TEST_CASE("4.2-curvature-adaptation, run: with a finer C benzene has so many triangles" *
          until(benzene_triangles)) {
  judge_run(benzene_triangles,
            meshed("benzene.pdb", support::with({0.03, 1.65})).certificate.triangles,
            "mesh bench/molecules/benzene.pdb -C 0.03 -o x.ply");
}

TEST_CASE("4.2-curvature-adaptation, explain: the closed form is the derivation's, for all C, Q" *
          until(disk_share)) {
  Cases<double(double, double)> cases("C Q");
  for (int i = 1; i < 20; ++i) {
    for (int k = 0; k < 12; ++k) {
      const certify::Sizing sizing{0.01 * i, 1.42 + 0.05 * k};
      cases.add(sizing.tangent_disk_share(), sizing.C, sizing.Q);
    }
  }
  const auto half_edge = [](double C, double Q) { return C * Q / (1 + 2 * C * Q); };
  cases.judge(disk_share,
              {{[=](double C, double Q) {
                  const double R = half_edge(C, Q);
                  return R * std::sqrt(1 - R * R);
                },
                "That is the closed form as printed, which lost a factor."},
               {half_edge, "That is half the edge, R."},
               {[=](double C, double Q) { return 2 * half_edge(C, Q); },
                "That is the edge; its end lies lower than the disk's rim."},
               {[](double C, double Q) { return 2 * C * Q * std::sqrt(1 - C * C * Q * Q); },
                "The length scale may be smaller at the other end."}});
}
