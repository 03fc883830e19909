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
    const auto located = certify::locate_with_bounds(mesh, skin);
    for (std::size_t v = 0; v < located.size(); ++v) {
      const certify::LocatedVertex& at = located[v];
      const surface::SurfacePoint point = at.at(mesh.positions[v]);
      const surface::Enclosure found = skin.enclose(mesh.positions[v], at.cell);
      CHECK(static_cast<double>(at.low) <= found.low);
      CHECK(static_cast<double>(at.high) >= found.high);
      CHECK(at.max_value() >= found.max_value());
      const Wide told =
          static_cast<long double>(point.length_scale) * point.normal.cast<long double>();
      const long double off = (found.half_gradient.cast<long double>() - told).norm();
      CHECK(static_cast<long double>(at.error) >= found.error + off);
      // No wider than a float's last digit.
      CHECK(static_cast<double>(at.high) <= found.high + 0x1p-22 * std::abs(found.high));
      CHECK(static_cast<double>(at.low) >= found.low - 0x1p-22 * std::abs(found.low));
    }
  });
}

TEST_CASE("the location of many vertices ends when it is asked to") {
  const skin::SkinSurface skin(support::ball_set(0));
  geometry::IndexedMesh mesh;
  mesh.positions.assign(3, skin.bounding_ball().centre);
  mesh.triangles.assign(100'000, {0, 1, 2});
  std::stop_source source;
  const geometry::Run run(1, {}, source.get_token());
  CHECK(certify::locate_vertices(mesh, skin, run).size() == 3);
  source.request_stop();
  CHECK_THROWS_AS(certify::locate_vertices(mesh, skin, run), geometry::Stopped);
}
