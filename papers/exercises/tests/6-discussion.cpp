#include "answers/6-discussion.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("6-discussion, predict: the critical points of a distance on the cube add up to this" *
          until(distance_sum)) {
  const skin::SkinSurface skin(support::molecule("cube8.xyzr", skin::Model::Paper));
  const auto critical =
      morse::critical_points(skin, morse::MorseFunction::squared_distance({1, 9, 2}));
  REQUIRE(critical.degeneracies.empty());
  CHECK(*distance_sum == critical.euler_characteristic());
}

TEST_CASE("6-discussion, run: the distance has so many minima, and the mesh is certified" *
          until(distance_minima)) {
  const MeshResult result =
      meshed("caffeine.xyz",
             {.sizing = {}, .function = morse::MorseFunction::squared_distance({0, 0, 0})});
  CHECK(result.certificate.certified);
  CHECK(*distance_minima == static_cast<long>(result.critical_points[0]));
}

TEST_CASE("6-discussion, explain: from far away the distance is the height" * until(as_height)) {
  support::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const skin::Vector V = random.direction();
    const skin::Point x = random.in_cube(-9, 9);
    for (const double R : {1e3, 1e4, 1e5}) {
      const auto f = morse::MorseFunction::squared_distance(-R * V);
      CHECK(std::abs((*as_height)(f(x), R) - V.dot(x)) <= x.squaredNorm() / R);
    }
  }
}
