// Surface balls: exact ones, and the bounds that mostly decide in their place.

#include "tests/support/refined_meshes.h"

using namespace morskin;
using namespace morskin::refine;
using namespace morskin::support;

TEST_CASE("a surface ball is centred on the skin and passes through its triangle's corners") {
  for (const PreparedSkin& skin : small_skins()) {
    const Mesh mesh = refined_mesh(skin);
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
      const SurfaceBall around =
          exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
      const double rho = mesh.at(a).length_scale;
      // What rounding leaves of a length of the order of rho, and twice G over its slope.
      const double off = 1e-10 * rho;
      CHECK(std::abs(skin.surface.value(around.centre, mesh.at(a).cell)) <= 2 * rho * off);
      for (const VertexId v : {a, b, c}) {
        CHECK(std::abs(around.intrusion(mesh.position(v))) <= 2 * off * rho);
      }
    }
  }
}

TEST_CASE("a surface ball found to rounding is as deep as its bounds say, and they mostly decide") {
  for (const PreparedSkin& skin : small_skins()) {
    const Mesh mesh = swept_mesh(skin);  // worse triangles than a refined one has
    std::size_t asked = 0, decided = 0;
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
      const SurfaceBall exact =
          exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
      if (!exact.is_exact) continue;
      LazySurfaceBall ball(skin.surface, {&mesh.at(a), &mesh.at(b), &mesh.at(c)},
                           circumcircle(mesh.position(a), mesh.position(b), mesh.position(c)));
      const double rounding = 1e-8 * exact.squared_radius;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
        const Point& p = mesh.position(mesh.surface.apex(mesh.surface.twin(h)));
        const double depth = exact.intrusion(p);
        const Depth bounds = ball.depth(p), intrusion = ball.intrusion(p);
        CHECK(bounds.min <= depth + rounding);
        CHECK(bounds.max >= depth - rounding);
        if (std::abs(depth) > rounding) CHECK((intrusion.max > 0) == (depth > 0));
        ++asked;
        decided += bounds.max <= 0 || bounds.min > 0;
      }
    }
    CHECK(10 * decided > 9 * asked);
  }
}

TEST_CASE(
    "G and N at the circumcentre bound a surface ball's depth closely, of coarse triangles too") {
  std::size_t asked = 0, decided = 0, by_corners = 0;
  for (const PreparedSkin& skin : small_skins()) {
    morskin::MeshingOptions options = uncertified();
    options.sizing = {0.4, certify::Sizing::quality_for(0.4)};
    const Mesh mesh = skin_mesh(skin.surface, morskin::make_mesh(skin, options));
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
      const SurfaceBall exact =
          exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
      const surface::Corners corners{&mesh.at(a), &mesh.at(b), &mesh.at(c)};
      const auto circle = circumcircle(mesh.position(a), mesh.position(b), mesh.position(c));
      const auto narrow = certify::ball_pencil_by_centre(skin.surface, corners, circle);
      if (!exact.is_exact || !narrow) continue;
      const double rounding = 1e-8 * exact.squared_radius;
      CHECK(narrow->max_squared_radius() >= exact.squared_radius - rounding);
      const auto wide = certify::ball_pencil(skin.surface, corners, circle);
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{t}, k);
        const Point& p = mesh.position(mesh.surface.apex(mesh.surface.twin(h)));
        const double depth = exact.intrusion(p);
        const Depth bounds = narrow->depth(p);
        CHECK(bounds.min <= depth + rounding);
        CHECK(bounds.max >= depth - rounding);
        ++asked;
        decided += bounds.max <= 0 || bounds.min > 0;
        by_corners += wide && (wide->depth(p).max <= 0 || wide->depth(p).min > 0);
      }
    }
  }
  CHECK(10 * decided > 9 * asked);
  CHECK(2 * by_corners < asked);  // where it is needed
}
