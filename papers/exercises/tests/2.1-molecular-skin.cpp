#include "answers/2.1-molecular-skin.h"

#include "papers/exercises/tests/course_support.h"
#include "skin/waists.h"

using namespace morskin;

TEST_CASE("2.1-molecular-skin, predict: nearer the two balls have one skin, farther they have two" *
          until(touching_distance)) {
  const auto components_at = [](double distance) {
    const PreparedSkin skin =
        prepare_skin({{{0, 0, 0}, 2}, {{geometry::on_exact_grid(distance), 0, 0}, 2}});
    return skin.topology.skin_components();
  };
  const auto is_right = [&](double distance) {
    return components_at(distance - 1e-6) == 1 && components_at(distance + 1e-6) == 2;
  };
  judge<double>(touching_distance, is_right,
                {{2,
                  "There the spheres of radius sqrt(w/2) touch; a neck still joins them. Ask "
                  "when the edge's weight is zero."},
                 {4, "A weight is the square of a radius."},
                 {std::sqrt(2.0), "So far is the middle from each centre."}});
}

TEST_CASE("2.1-molecular-skin, run: so many waists of gramicidin's skin are necks" * until(necks)) {
  const skin::SkinSurface skin(support::molecule("1grm_model1.pdb", skin::Model::Vdw));
  const std::vector<skin::Waist> waists = skin::waists(skin);
  const auto count = std::count_if(waists.begin(), waists.end(),
                                   [](const skin::Waist& w) { return !w.is_tunnel; });
  judge_run(necks, static_cast<std::size_t>(count), "info bench/molecules/1grm_model1.pdb");
}

TEST_CASE("2.1-molecular-skin, explain: the formula is the curvature along the meridian" *
          until(smaller_curvature)) {
  Cases<double(double, double)> cases("half_weight distance");
  cases.add(1, 1, 1);  // the waist of a neck, as wide as it is curved
  support::for_skins(20, [&](const PreparedSkin& skin) {
    const skin::MixedComplex& complex = skin.surface.complex();
    support::Random random(1);
    for (std::size_t i = 0; i < complex.size(); ++i) {
      const skin::Patch& patch = complex.patch(geometry::CellId{i});
      if (patch.axis.isZero(0)) continue;
      const skin::Point x = patch.slide(patch.centre + random.direction());
      const double rho = patch.length_scale(x);
      if (std::abs(patch.value(x)) > 1e-9 * rho * rho) continue;  // the line misses the quadric
      const skin::Vector around = patch.axis.cross(x - patch.centre);
      if (around.norm() < 1e-6 * rho) continue;
      const skin::Vector meridian = around.cross(patch.normal(x)).normalized();
      const double curvature = std::abs(meridian.dot(patch.reflect(meridian))) / rho;
      cases.add(curvature, patch.half_weight, rho);
    }
  });
  cases.judge(smaller_curvature,
              {{[](double, double u) { return 1 / u; }, "That is the larger one."},
               {[](double h, double u) { return std::abs(h) / (u * u); },
                "That has no unit; a curvature is one over a length."},
               {[](double h, double u) { return h / (u * u * u); },
                "Without its sign: a weight may be negative."},
               {[](double h, double u) { return 2 * std::abs(h) / (u * u * u); },
                "Half the weight goes in, not the whole one."}});
}
