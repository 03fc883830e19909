#include "answers/2.1-molecular-skin.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("2.1-molecular-skin, predict: nearer the two balls have one skin, farther they have two" *
          until(touching_distance)) {
  const auto components_at = [](double distance) {
    const PreparedSkin skin =
        prepare_skin({{{0, 0, 0}, 2}, {{geometry::on_exact_grid(distance), 0, 0}, 2}});
    return skin.topology.skin_components();
  };
  CHECK(components_at(*touching_distance - 1e-6) == 1);
  CHECK(components_at(*touching_distance + 1e-6) == 2);
}

TEST_CASE("2.1-molecular-skin, run: the counts are those of the cube's dual complex" *
          until(cube_components, cube_euler_characteristic)) {
  const PreparedSkin skin = prepare_skin(support::molecule("cube8.xyzr", skin::Model::Paper));
  CHECK(*cube_components == static_cast<long>(skin.topology.skin_components()));
  CHECK(*cube_euler_characteristic == skin.topology.skin_euler_characteristic());
}

TEST_CASE("2.1-molecular-skin, explain: the formula is the curvature along the meridian" *
          until(smaller_curvature)) {
  support::for_skins(20, [](const PreparedSkin& skin) {
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
      CHECK((*smaller_curvature)(patch.half_weight, rho) == doctest::Approx(curvature));
    }
  });
}
