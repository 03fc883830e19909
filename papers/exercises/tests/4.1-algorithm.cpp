#include "answers/4.1-algorithm.h"

#include "geometry/dissection.h"
#include "morse/choose_function.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-algorithm, predict: the reversed function has these critical points" *
          until(of_reversed)) {
  const PreparedSkin skin = prepare_skin(support::molecule("5tmn_ligand.pdb", skin::Model::Paper));
  const auto function = morse::MorseFunction{}.reversed();
  const auto critical = morse::critical_points(skin.surface, function);
  REQUIRE(critical.degeneracies.empty());
  const auto is_right = [&](const std::array<long, 3>& given) {
    for (int index = 0; index < 3; ++index) {
      if (given[static_cast<std::size_t>(index)] != static_cast<long>(critical.count(index)))
        return false;
    }
    return true;
  };
  judge<std::array<long, 3>>(of_reversed, is_right,
                             {{{5, 12, 7}, "What is a lowest point when up and down are swapped?"},
                              {{7, -12, 5}, "A number of points is not negative."},
                              {{-5, -12, -7}, "The function changes its sign, not the counts."}});
}

TEST_CASE("4.1-algorithm, run: so many bowls are made on a protein of a virus in subdomains" *
          until(bowls_of_subdomains)) {
  judge_run(bowls_of_subdomains,
            meshed("2buk.pdb.gz", support::with(support::sizing_for(0.2))).operations.creation,
            "mesh bench/molecules/2buk.pdb.gz -C 0.2 -o x.ply --json; it is operations.creation");
}

TEST_CASE("4.1-algorithm, explain: so many boxes has a dissection" * until(sweeps)) {
  Cases<double(double)> cases("d");
  for (const int depth : {0, 1, 2, 5, 9}) {
    cases.add(static_cast<double>(geometry::Dissection({}, depth).size()), depth);
  }
  cases.judge(
      sweeps,
      {{[](double d) { return std::exp2(d); },
        "Between two halves a strip is left, which is swept as well."},
       {[](double d) { return 2 * std::exp2(d); }, "Without any halving there is one sweep."},
       {[](double d) { return std::exp2(d) + d; },
        "At each level every box has a strip, not only one of them."},
       {[](double d) { return 2 * d + 1; }, "Both halves are halved, so their number doubles."}});
}
