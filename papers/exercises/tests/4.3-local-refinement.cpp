#include "answers/4.3-local-refinement.h"

#include "certify/triangle_geometry.h"
#include "geometry/glued_triangles.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.3-local-refinement, predict: a split adds so many triangles" *
          until(triangles_of_an_insertion)) {
  geometry::SurfaceMesh mesh = geometry::closed_mesh(6, support::octahedron()).mesh;
  const std::size_t before = mesh.triangle_count();
  mesh.split(geometry::TriangleId{0U}, mesh.add_vertex());
  const long more = static_cast<long>(mesh.triangle_count() - before);
  judge<long>(triangles_of_an_insertion, [&](long given) { return given == more; },
              {{3, "One of them takes the place of the old triangle."},
               {1, "The new vertex is joined to all corners of the triangle."},
               {0, "A flip adds none; an insertion does."}});
}

TEST_CASE("4.3-local-refinement, run: so many vertices are inserted on 9DNA" * until(insertions)) {
  judge_run(insertions, meshed("9dna.pdb", one_front()).refinement.insert,
            "mesh bench/molecules/9dna.pdb --fronts 1 -o x.ply --json; it is operations.insert");
}

TEST_CASE("4.3-local-refinement, explain: an edge is flipped when a corner is in the other circle" *
          until(flip)) {
  support::Random random(1);
  const auto angle = [](const skin::Point& at, const skin::Point& p, const skin::Point& q) {
    return std::acos((p - at).normalized().dot((q - at).normalized()));
  };
  Cases<bool(double, double)> cases("one other");
  cases.add(true, 2, 1.5);
  cases.add(false, 2, 1);
  for (int i = 0; i < 1000; ++i) {
    const skin::Point a(0, 0, 0), b(1, 0, 0);
    const skin::Point c(random.between(-1, 2), random.between(0.1, 2), 0);
    const skin::Point d(random.between(-1, 2), random.between(-2, -0.1), 0);
    const auto circle = certify::circumcircle(a, b, c);
    cases.add((d - circle.centre).norm() < circle.radius, angle(c, a, b), angle(d, a, b));
  }
  cases.judge(flip,
              {{[](double one, double other) { return one + other < M_PI; },
                "The other way round: draw two flat triangles on a common edge."},
               {[](double one, double other) { return std::max(one, other) > M_PI / 2; },
                "One of the angles alone does not tell."},
               {[](double one, double other) { return one + other > M_PI / 2; },
                "Angles over a chord on both sides of it: what do they add up to?"},
               {[](double one, double other) { return one + other > 180; }, "Radians, please."}});
}
