#include "front/neighbourhood.h"

#include "tests/support/plane_front.h"

using namespace morskin;
using namespace morskin::front;
using namespace morskin::support;

TEST_CASE("the bare angle of a corner is what its fan leaves of the full turn") {
  for (int n = 3; n < 9; ++n) {
    CAPTURE(n);
    Plane plane;
    const auto polygon = plane.fan(0, 0, 0.15, 0.2, n);
    Neighbourhood near(plane.mesh, plane.front);
    near.gather(flat(0, 0));
    const double inside = M_PI - 2 * M_PI / n;
    for (const FrontEdgeId corner : polygon) {
      CHECK(std::abs(near.bare_angle(corner) - (2 * M_PI - inside)) < 1e-12);
      CHECK_FALSE(near.is_acute(corner, std::cos(75 * M_PI / 180)));
    }
  }
}

TEST_CASE("a notch in the front is acute, and no more than its angle") {
  for (const double angle_deg : {20.0, 50.0, 70.0, 80.0, 89.0}) {
    CAPTURE(angle_deg);
    // A disk with a notch whose two sides leave `tip` at this angle.
    Plane plane;
    const double half = angle_deg / 2 * M_PI / 180, r = 0.2;
    const VertexId centre = plane.mesh.add_vertex(flat(-0.1, 0));
    const VertexId tip = plane.mesh.add_vertex(flat(0, 0));
    std::vector<VertexId> rim{
        tip, plane.mesh.add_vertex(flat(r * std::cos(half), r * std::sin(half))),
        plane.mesh.add_vertex(flat(-0.2, 0.15)), plane.mesh.add_vertex(flat(-0.2, -0.15)),
        plane.mesh.add_vertex(flat(r * std::cos(half), -r * std::sin(half)))};
    const auto polygon = plane.open(centre, rim);
    Neighbourhood near(plane.mesh, plane.front);
    near.gather(flat(0, 0));
    CHECK(std::abs(near.bare_angle(polygon[0]) - 2 * half) < 1e-12);
    for (const double limit_deg : {30.0, 60.0, 75.0, 85.0}) {
      CAPTURE(limit_deg);
      CHECK(near.is_acute(polygon[0], std::cos(limit_deg * M_PI / 180)) == (angle_deg < limit_deg));
    }
    // The edge before the tip sees, over the notch, the end of the edge after it.
    CHECK(near.sees(polygon[0], polygon[4]));
    CHECK(near.delaunay_apex(polygon[0]) == polygon[4]);
  }
}

TEST_CASE("an edge of a lone convex front has no apex") {
  Plane plane;
  const auto polygon = plane.fan(0, 0, 0.15, 0);
  Neighbourhood near(plane.mesh, plane.front);
  near.gather(flat(0, 0));
  for (const FrontEdgeId e : polygon) CHECK_FALSE(near.delaunay_apex(e).has_value());
}

TEST_CASE(
    "an edge across a gap has the nearest corner opposite as its apex, unless one stands between") {
  Plane plane;
  // The last edge of the left fan faces right, at x = 0.1 sqrt(3) / 2; the first corner of the
  // right fan is its nearest, on the x axis.
  const auto left = plane.fan(0, 0, 0.1, M_PI / 6), right = plane.fan(0.3, 0, 0.1, M_PI);
  const FrontEdgeId facing = left[5];
  {
    Neighbourhood near(plane.mesh, plane.front);
    near.gather(flat(0.1, 0));
    CHECK(near.sees(facing, right[0]));
    CHECK_FALSE(near.sees(facing, right[3]));  // behind its own fan
    CHECK(near.delaunay_apex(facing) == right[0]);
  }
  // A third fan in the gap, large enough to hide that corner.
  const auto between = plane.fan(0.15, 0, 0.03, M_PI);
  Neighbourhood near(plane.mesh, plane.front);
  near.gather(flat(0.1, 0));
  CHECK_FALSE(near.sees(facing, right[0]));
  CHECK(near.delaunay_apex(facing) == between[0]);
}

TEST_CASE("the apex has no corner that the edge sees in its circle") {
  std::size_t found = 0;
  for_seeds<Random>(500, [&](Random& random) {
    Plane plane;
    std::vector<FrontEdgeId> corners = plane.fan(0, 0, 0.08, random.between(0, 1));
    const FrontEdgeId e = corners[0];
    for (int i = 0; i < 5; ++i) {  // small fans around, none over another
      const double a = 2 * M_PI * (i + random.between(0, 0.4)) / 5, d = random.between(0.16, 0.22);
      for (const FrontEdgeId c : plane.fan(d * std::cos(a), d * std::sin(a),
                                           random.between(0.02, 0.05), random.between(0, 3), 5)) {
        corners.push_back(c);
      }
    }
    Neighbourhood near(plane.mesh, plane.front);
    near.gather(flat(0, 0));
    const auto apex = near.delaunay_apex(e);
    if (!apex) return;
    ++found;
    CHECK(near.sees(e, *apex));
    const Point p = plane.front[e].position, w = plane.front.next(e).position;
    const Point v = plane.front[*apex].position;
    // Centre and radius of the circle through the three.
    const Vector m = (w - p), n = (v - p);
    const double area2 = m.x() * n.y() - m.y() * n.x();
    CHECK(area2 < 0);  // on the edge's right, where the plane is bare
    const double mm = m.squaredNorm(), nn = n.squaredNorm();
    const Point centre =
        p + Vector(n.y() * mm - m.y() * nn, m.x() * nn - n.x() * mm, 0) / (2 * area2);
    const double radius = (centre - p).norm();
    for (const FrontEdgeId c : corners) {
      const Point x = plane.front[c].position;
      // Vertices nearly in line with the edge make no triangle.
      const double height = -(m.x() * (x - p).y() - m.y() * (x - p).x()) / mm;
      if (x == p || x == w || x == v || height < 0.06 || !near.sees(e, c)) continue;
      CHECK((x - centre).norm() > radius * (1 - 1e-9));
    }
  });
  CHECK(found > 100);
}

TEST_CASE("a new vertex is clear only away from vertices, edges and the far side of the front") {
  Plane plane;
  const auto left = plane.fan(0, 0, 0.1, M_PI / 6), right = plane.fan(0.3, 0, 0.1, M_PI);
  const FrontEdgeId facing = left[5];
  Neighbourhood near(plane.mesh, plane.front);
  near.gather(flat(0.1, 0));
  const auto is_clear = [&](double x, double y, double vertex_gap, double edge_gap) {
    return near.is_clear(facing, near.local({x, y, 0}), vertex_gap, edge_gap);
  };
  CHECK(is_clear(0.15, 0, 0.04, 0.02));
  CHECK_FALSE(is_clear(0.15, 0, 0.06, 0.02));      // the corner at (0.2, 0) is 0.05 away
  CHECK_FALSE(is_clear(0.196, 0.02, 0.01, 0.03));  // an edge of the right fan is nearer than that
  CHECK_FALSE(is_clear(0.05, 0, 0.001, 0.001));    // on the meshed side of its own edge
  CHECK_FALSE(is_clear(0.45, 0, 0.001, 0.001));    // beyond the right fan: its sides cross edges
}

TEST_CASE("a neighbourhood's frame keeps lengths and puts its centre at the origin") {
  for_seeds<Random>(100, [&](Random& random) {
    const Plane plane;
    Neighbourhood near(plane.mesh, plane.front);
    const SurfacePoint centre{random.between(0, 5) * random.direction(), random.direction(), 1,
                              geometry::CellId{}};
    near.gather(centre);
    constexpr double rounding = 1e-14;
    const Vector2 at(random.between(-0.4, 0.4), random.between(-0.4, 0.4));
    const LocalPoint back = near.local(near.in_space(at));
    CHECK((back.plane - at).norm() < 10 * rounding);
    CHECK(std::abs(back.height) < 10 * rounding);
    const Point x = centre.position + 0.4 * random.direction();
    const LocalPoint local = near.local(x);
    CHECK(std::abs(local.squared_distance(near.local(centre.position)) -
                   (x - centre.position).squaredNorm()) < 10 * rounding);
    CHECK(std::abs(local.height - centre.normal.dot(x - centre.position)) < 10 * rounding);
  });
}
