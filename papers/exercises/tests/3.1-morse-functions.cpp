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
  const auto is_right = [&](const std::array<long, 3>& given) {
    for (int index = 0; index < 3; ++index) {
      if (given[static_cast<std::size_t>(index)] != static_cast<long>(critical.count(index)))
        return false;
    }
    return true;
  };
  judge<std::array<long, 3>>(
      dumbbell, is_right,
      {{{1, 0, 1}, "That is the dumbbell standing up."},
       {{2, 1, 2}, "Their sum with signs is 3. The neck has a lower side and an upper one."},
       {{2, 1, 1}, "Each ball has a highest point of its own."},
       {{2, 4, 2}, "Their sum with signs is 0, a torus's."}});
}

TEST_CASE("3.1-morse-functions, run: the height has as many saddles" * until(saddles)) {
  const skin::SkinSurface skin(support::molecule("1grm_model1.pdb", skin::Model::Vdw));
  const auto critical = morse::critical_points(
      skin, morse::MorseFunction::height(skin::Vector(3, 1, 2).normalized()));
  judge_run(saddles, critical.count(1),
            "morse bench/molecules/1grm_model1.pdb --function height:3,1,2 -o x.json; it is "
            "before.saddles");
}

TEST_CASE("3.1-morse-functions, explain: lambda is the length scale at every critical point" *
          until(squared_lambda)) {
  Cases<double(double, double)> cases("half_weight D");
  cases.add(0.5, 0.5, 1);
  cases.add(2, 0.5, 0.25);
  support::for_skins(30, [&](const PreparedSkin& skin) {
    const morse::MorseFunction f;
    for (const auto& p : morse::critical_points(skin.surface, f).points) {
      const skin::Patch& patch = skin.surface.complex().patch(p.point.cell);
      const double rho = p.point.length_scale;
      cases.add(rho * rho, patch.half_weight, f.direction.dot(patch.reflect(f.direction)));
    }
  });
  cases.judge(
      squared_lambda,
      {{[](double h, double D) { return h * D; },
        "Put u = lambda M V into u . M u = w/2, and use M M = I."},
       {[](double h, double D) { return h / (D * D); }, "M M = I: of the three M one is left."},
       {[](double h, double D) { return 2 * h / D; }, "w/2 is half the weight already."},
       {[](double h, double D) { return std::sqrt(h / D); }, "That is lambda, not its square."}});
}
