// What things hide of the light, and that nothing else takes from it.

#include "app/pictures/light.h"

#include "app/pictures/raster.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::pictures;

TEST_CASE("a ball in the open casts no shadow on itself") {
  // Shadows come from depth maps with samples of their own; where nothing else stands in the way
  // they must leave a smooth surface as it is.
  Occluders ball;
  ball.balls.push_back({Vector(50, 50, 0), 40});
  std::vector<Spot> spots;
  for_each_sample_of_ball(
      {100, 100}, Vector(50, 50, 0), 40, [&](int x, int y, double depth, const Vector& normal) {
        spots.push_back({Vector(x + 0.5, y + 0.5, depth).cast<float>(), normal.cast<float>()});
      });
  CHECK(spots.size() > 4900);  // pi 40^2 = 5027
  const Illumination with = illuminated(ball, spots, 100, true);
  const Illumination without = illuminated(ball, spots, 100, false);
  double largest = 0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    largest =
        std::max(largest, std::abs(static_cast<double>(with.diffuse[i] - without.diffuse[i])));
  }
  CHECK(largest < 0.05);
}

TEST_CASE("a place under a roof is darker the lower the roof is") {
  const std::vector<Spot> spots{{{0, 0, 0}, {0, 0, 1}}, {{300, 300, 0}, {0, 0, 1}}};
  double before = 0;
  for (const double height : {20.0, 40.0, 80.0, 160.0}) {
    CAPTURE(height);
    Occluders roof;
    roof.corners = {Vector(-60, -60, height), Vector(60, -60, height), Vector(60, 60, height),
                    Vector(-60, 60, height)};
    roof.triangles = {{0, 1, 2}, {0, 2, 3}};
    const Illumination light = illuminated(roof, spots, 400, true);
    CHECK(static_cast<double>(light.diffuse[0]) > before);
    CHECK(light.diffuse[0] < light.diffuse[1]);
    before = static_cast<double>(light.diffuse[0]);
  }
}
