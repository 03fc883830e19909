#include "answers/4.1-algorithm.h"

#include "morse/choose_function.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-algorithm, predict: the reversed function has these critical points" *
          until(from_above)) {
  const PreparedSkin skin = prepare_skin(support::molecule("5tmn_ligand.pdb", skin::Model::Paper));
  const auto function = morse::MorseFunction{}.reversed();
  const auto critical = morse::critical_points(skin.surface, function);
  REQUIRE(critical.degeneracies.empty());
  for (int index = 0; index < 3; ++index) {
    CAPTURE(index);
    CHECK((*from_above)[static_cast<std::size_t>(index)] ==
          static_cast<long>(critical.count(index)));
  }
}

TEST_CASE("4.1-algorithm, run: so many bowls are made on 9DNA from both ends" *
          until(bowls_of_both)) {
  CHECK(*bowls_of_both == static_cast<long>(meshed("9dna.pdb").operations.creation));
}

TEST_CASE(
    "4.1-algorithm, explain: f rises by no more within the distance, and by no less along it" *
    until(largest_rise)) {
  support::Random random(7);
  const auto vector = [&] { return random.in_cube(-2, 2); };
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const double c = random.between(0, 2), d = random.between(0.01, 2.01);
    const morse::MorseFunction f{vector(), vector(), c};
    const geometry::Point x = vector();
    const double rise = (*largest_rise)(f.gradient(x).norm(), c, d);
    CHECK(f(x + d * f.gradient(x).normalized()) - f(x) == doctest::Approx(rise));
    for (int k = 0; k < 20; ++k) {
      const geometry::Vector e = d * vector().normalized();
      CHECK(f(x + e) - f(x) <= rise * (1 + 1e-12) + 1e-12);
    }
  }
}
