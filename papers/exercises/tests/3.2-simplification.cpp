#include "answers/3.2-simplification.h"

#include "morse/simplification.h"
#include "papers/exercises/tests/course_support.h"
#include "tests/support/morse_complexes.h"

using namespace morskin;

TEST_CASE("3.2-simplification, predict: so many critical points are left on gramicidin A" *
          until(left_on_gramicidin)) {
  const skin::SkinSurface skin(support::molecule("1grm_model1.pdb", skin::Model::Paper));
  const morse::MorseFunction f;
  const auto complex = morse::morse_smale_complex(skin, f, morse::critical_points(skin, f));
  const auto simple = morse::cancel_up_to(complex, INFINITY, 0.2);
  CHECK(*left_on_gramicidin == std::count(simple.survives.begin(), simple.survives.end(), true));
}

TEST_CASE("3.2-simplification, run: so many saddles survive on 9DNA" * until(saddles_left)) {
  CHECK(*saddles_left == static_cast<long>(meshed("9dna.pdb").surviving_points[1]));
}

TEST_CASE("3.2-simplification, explain: the least persistent pair may always go, never the elder" *
          until(may_cancel)) {
  using Id = morse::CriticalId;
  support::Random random(1);
  for (unsigned i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const auto complex = support::complex_of(support::random_graph(random, 12), random);
    const auto value = [&](Id p) { return complex.points[p.index()].value; };
    for (const morse::PersistencePair& pair : morse::persistence_pairs(complex)) {
      if (complex.points[pair.extremum.index()].index != 0) continue;
      // The lowest other saddle of the minimum, of those that lead elsewhere as well.
      double lowest = INFINITY;
      Id other_end = pair.extremum;
      for (std::size_t a = 0; a < complex.arcs.size(); a += 2) {
        const morse::Arc& arc = complex.arcs[a];
        const Id twin = complex.arcs[a % 4 == 0 ? a + 2 : a - 2].extremum;
        if (arc.extremum != pair.extremum || twin == pair.extremum) continue;
        if (arc.saddle == pair.saddle) {
          other_end = twin;
        } else {
          lowest = std::min(lowest, value(arc.saddle));
        }
      }
      const double a = value(pair.saddle), b = value(pair.extremum), c = value(other_end);
      if (other_end == pair.extremum) continue;  // another pair has to go first
      CHECK((*may_cancel)(b, c, a, lowest) == (c <= b && a <= lowest));
      if (c < b) CHECK_FALSE((*may_cancel)(c, b, a, lowest));
      break;
    }
  }
}
