#include "answers/6-discussion.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("6-discussion, predict: the critical points of a distance on the cube add up to this" *
          until(distance_sum)) {
  const skin::SkinSurface skin(support::molecule("cube8.xyzr", skin::Model::Paper));
  const auto critical =
      morse::critical_points(skin, morse::MorseFunction::squared_distance({1, 9, 2}));
  REQUIRE(critical.degeneracies.empty());
  judge<long>(
      distance_sum, [&](long given) { return given == critical.euler_characteristic(); },
      {{2, "That is one sphere's. The cube's skin has a void within; what does its height give?"},
       {20, "Saddles count negatively."},
       {0, "A distance has fewer or more points than a height. Does their sum change?"}});
}

TEST_CASE("6-discussion, run: the distance has so many saddles, and the mesh is certified" *
          until(distance_saddles)) {
  const MeshResult result =
      meshed("1grm_model1.pdb",
             {.sizing = {}, .function = morse::MorseFunction::squared_distance({5, 2, 1})});
  REQUIRE(result.certificate.certified);
  judge_run(distance_saddles, result.critical_points[1],
            "mesh bench/molecules/1grm_model1.pdb --function distance:5,2,1 -o x.ply --json; it "
            "is saddles");
}

TEST_CASE("6-discussion, explain: from far away the distance is the height" * until(as_height)) {
  support::Random random(1);
  Cases<double(double, double)> cases("f R");
  for (int i = 0; i < 100; ++i) {
    const skin::Vector V = random.direction();
    const skin::Point x = random.in_cube(-9, 9);
    for (const double R : {1e3, 1e4, 1e5}) {
      const auto f = morse::MorseFunction::squared_distance(-R * V);
      cases.add_within(x.squaredNorm() / R, V.dot(x), f(x), R);
    }
  }
  cases.judge(as_height,
              {{[](double f, double R) { return f - R * R; },
                "Shifted right, but it grows with R: scale it."},
               {[](double f, double R) { return f / (2 * R); },
                "Scaled right, but it grows with R: shift it."},
               {[](double f, double R) { return (f - R * R) / R; },
                "Expand |x + R V|^2: how often does V . x come in?"},
               {[](double f, double R) { return (R * R - f) / (2 * R); },
                "That is the height along -V: the point lies below, far away along -V."}});
}
