#include "bench/baselines/hot_region.h"

#include <numbers>

#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::baselines;
using namespace morskin::support;

namespace {

/// A loop about the axis on the unit sphere that wanders up and down, and now and then steps back.
Ring jagged_ring(MovingMesh& mesh, const Frame& frame, CellId cell, Random& random, double axial) {
  const auto share = [&] { return random.between(-1, 1); };
  const int count = static_cast<int>(random.whole(3, 50));
  const double step = 2 * std::numbers::pi / count;
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double height = axial + 0.15 * share();
    const double azimuth = (i + 1.5 * share()) * step;
    const Point x = frame.point(std::sqrt(1 - height * height), azimuth, height);
    ring.push_back(mesh.add_vertex(*mesh.level().project(x, cell)));
  }
  return ring;
}

}  // namespace

TEST_CASE("the strip between two rings is an annulus, however jagged they are") {
  const auto skin = prepared({ball(0, 0, 0, 1)});
  REQUIRE(skin.has_value());
  const CellId cell = skin->surface.locate({0, 0, 0}, CellId{0U});
  Random random(7);
  for (int set = 0; set < 500; ++set) {
    MovingMesh mesh(skin->surface, certify::Sizing{});
    const Frame frame(skin->surface.patch(cell));
    const Ring lower = jagged_ring(mesh, frame, cell, random, -0.1);
    const Ring upper = jagged_ring(mesh, frame, cell, random, 0.1);
    std::vector<Corners> triangles;
    join(mesh, lower, upper, triangles);
    CHECK(triangles.size() == lower.size() + upper.size());
    close(Ring(lower.rbegin(), lower.rend()), mesh.add_vertex(mesh.at(lower[0])), triangles);
    close(upper, mesh.add_vertex(mesh.at(upper[0])), triangles);
    REQUIRE(add_triangles(mesh.surface(), triangles, {}));
    CHECK(geometry::validate(mesh.surface()) == std::nullopt);
    CHECK(geometry::components(mesh.surface()).count == 1);
  }
}
