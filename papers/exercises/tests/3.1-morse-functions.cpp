#include "answers/3.1-morse-functions.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("3.1-morse-functions, predict: the counts are those of a neck between two balls" *
          until(dumbbell)) {
  const PreparedSkin skin =
      prepare_skin({support::ball(0, 0, 0, 1.5), support::ball(3, 0, 0, 1.5)});
  const auto critical =
      morse::critical_points(skin.surface, morse::MorseFunction::height({0.02, 1, 0.03}));
  REQUIRE(critical.degeneracies.empty());
  for (int index = 0; index < 3; ++index) {
    CAPTURE(index);
    CHECK((*dumbbell)[static_cast<std::size_t>(index)] == static_cast<long>(critical.count(index)));
  }
}

TEST_CASE("3.1-morse-functions, run: caffeine has as many saddles" * until(caffeine_saddles)) {
  CHECK(*caffeine_saddles == static_cast<long>(meshed("caffeine.xyz").critical_points[1]));
}

TEST_CASE("3.1-morse-functions, explain: lambda is the length scale at every critical point" *
          until(squared_lambda)) {
  support::for_skins(30, [](const PreparedSkin& skin) {
    const morse::MorseFunction f;
    for (const auto& p : morse::critical_points(skin.surface, f).points) {
      const skin::Patch& patch = skin.surface.complex().patch(p.point.cell);
      const double D = f.direction.dot(patch.reflect(f.direction));
      const double rho = p.point.length_scale;
      CHECK((*squared_lambda)(patch.half_weight, D) == doctest::Approx(rho * rho));
    }
  });
}
