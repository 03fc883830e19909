#include "answers/4.3-local-refinement.h"

#include "certify/triangle_geometry.h"
#include "geometry/surface_mesh.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.3-local-refinement, predict: a split adds so many triangles" *
          until(triangles_of_an_insertion)) {
  geometry::SurfaceMesh mesh = geometry::closed_mesh(6, support::octahedron()).mesh;
  const std::size_t before = mesh.triangle_count();
  mesh.split(geometry::TriangleId{0U}, mesh.add_vertex());
  CHECK(*triangles_of_an_insertion == static_cast<long>(mesh.triangle_count() - before));
}

TEST_CASE("4.3-local-refinement, run: so many vertices are inserted on caffeine" *
          until(insertions)) {
  CHECK(*insertions == static_cast<long>(meshed("caffeine.xyz").refinement.insert));
}

TEST_CASE("4.3-local-refinement, explain: an edge is flipped when a corner is in the other circle" *
          until(flip)) {
  support::Random random(1);
  const auto angle = [](const skin::Point& at, const skin::Point& p, const skin::Point& q) {
    return std::acos((p - at).normalized().dot((q - at).normalized()));
  };
  for (int i = 0; i < 1000; ++i) {
    const skin::Point a(0, 0, 0), b(1, 0, 0);
    const skin::Point c(random.between(-1, 2), random.between(0.1, 2), 0);
    const skin::Point d(random.between(-1, 2), random.between(-2, -0.1), 0);
    const auto circle = certify::circumcircle(a, b, c);
    CHECK((*flip)(angle(c, a, b), angle(d, a, b)) == ((d - circle.centre).norm() < circle.radius));
  }
}
