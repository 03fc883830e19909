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
  const auto left = std::count(simple.survives.begin(), simple.survives.end(), true);
  judge<long>(
      left_on_gramicidin, [&](long given) { return given == left; },
      {{2, "That is a sphere's. Each handle keeps some saddles."},
       {70, "Those are the saddles."},
       {37, "A handle keeps more than one saddle: minima - saddles + maxima is 2 - 2 g."},
       {68, "That is the Euler characteristic without its sign. Saddles count negatively."}});
}

TEST_CASE("3.2-simplification, run: so many saddles survive on a protein of a virus" *
          until(saddles_left)) {
  judge_run(saddles_left,
            meshed("2buk.pdb.gz", support::with(support::sizing_for(0.2))).surviving_points[1],
            "mesh bench/molecules/2buk.pdb.gz -C 0.2 -o x.ply --json; it is surviving.saddles");
}

TEST_CASE("3.2-simplification, explain: the least persistent pair may always go, never the elder" *
          until(may_cancel)) {
  using Id = morse::CriticalId;
  Cases<bool(double, double, double, double)> cases("b c a lowest_other");
  cases.add(false, 1, 0, 4, 3);
  support::Random random(1);
  for (unsigned i = 0; i < 1000; ++i) {
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
      cases.add(c <= b && a <= lowest, b, c, a, lowest);
      if (c < b) cases.add(false, c, b, a, lowest);
      break;
    }
  }
  cases.judge(may_cancel,
              {{[](double b, double c, double, double) { return c <= b; },
                "The lower saddles of b have to go first."},
               {[](double, double, double a, double lowest_other) { return a <= lowest_other; },
                "Which of the two minima may go?"},
               {[](double b, double c, double a, double lowest_other) {
                  return b <= c && a <= lowest_other;
                },
                "The elder minimum, which is the lower one, stays."},
               {[](double, double, double, double) { return true; },
                "The result has to be the complex of a function near f."}});
}
