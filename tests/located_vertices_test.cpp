#include "certify/located_vertices.h"

#include "skin/skin_surface.h"
#include "tests/support/ball_sets.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::Point;

TEST_CASE("a vertex's bounds are rounded outwards, and count that length scale times normal is") {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  support::for_seeds(200, [](unsigned seed) {
    support::Random random(seed);
    const skin::SkinSurface skin(support::ball_set(seed));
    const surface::BoundingBall all = skin.bounding_ball();
    geometry::IndexedMesh mesh;
    for (int i = 0; i < 50; ++i) {
      mesh.positions.emplace_back(all.centre + all.radius * random.in_cube(-1, 1));
    }
    certify::VertexLocator locator(mesh, skin);
    locator.locate_rest();
    const auto points = locator.take_points();
    const auto bounds = locator.take_bounds();
    for (std::size_t v = 0; v < points.size(); ++v) {
      const surface::Enclosure found = skin.enclose(mesh.positions[v], points[v].cell);
      CHECK(static_cast<double>(bounds[v].low) <= found.low);
      CHECK(static_cast<double>(bounds[v].high) >= found.high);
      CHECK(bounds[v].max_value() >= found.max_value());
      const Wide told =
          static_cast<long double>(points[v].length_scale) * points[v].normal.cast<long double>();
      const long double off = (found.half_gradient.cast<long double>() - told).norm();
      CHECK(static_cast<long double>(bounds[v].error) >= found.error + off);
      // No wider than a float's last digit.
      CHECK(static_cast<double>(bounds[v].high) <= found.high + 0x1p-22 * std::abs(found.high));
      CHECK(static_cast<double>(bounds[v].low) >= found.low - 0x1p-22 * std::abs(found.low));
    }
  });
}
