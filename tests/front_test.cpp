#include "front/front.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "front/neighbourhood.h"
#include "front/operation_counter.h"
#include "tests/support/ball_sets.h"

using namespace morskin;
using namespace morskin::front;
using geometry::SurfaceMesh;
using support::Random;

namespace {

/// A point of a flat skin, the plane z = 0 with length scale 1.
SurfacePoint flat(double x, double y) {
  return {{x, y, 0}, Vector::UnitZ(), 1, geometry::CellId{}};
}

/// A front round regular fans of triangles laid by hand on the plane.
struct Plane {
  Mesh mesh;
  Front front{mesh};

  /// A fan about a centre; the front runs counter-clockwise round it, bare plane outside. Entry k
  /// leaves the corner at `angle` + k 2 pi / n.
  std::vector<FrontEdgeId> fan(double x, double y, double radius, double angle, int n = 6) {
    const VertexId centre = mesh.add_vertex(flat(x, y));
    std::vector<VertexId> rim;
    for (int k = 0; k < n; ++k) {
      const double a = angle + 2 * M_PI * k / n;
      rim.push_back(mesh.add_vertex(flat(x + radius * std::cos(a), y + radius * std::sin(a))));
    }
    return open(centre, rim);
  }
  /// A fan about a centre, given its rim counter-clockwise.
  std::vector<FrontEdgeId> open(VertexId centre, const std::vector<VertexId>& rim) {
    std::vector<geometry::TriangleId> fan;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      fan.push_back(mesh.surface.add_triangle(centre, rim[k], rim[(k + 1) % rim.size()]));
    }
    std::vector<HalfEdgeId> outer;
    for (std::size_t k = 0; k < fan.size(); ++k) {
      mesh.surface.glue(SurfaceMesh::half_edge(fan[k], 0),
                        SurfaceMesh::half_edge(fan[(k + fan.size() - 1) % fan.size()], 2));
      outer.push_back(SurfaceMesh::half_edge(fan[k], 1));
    }
    return front.open_polygon(outer);
  }
  std::vector<FrontEdgeId> open_edges() const {
    std::vector<FrontEdgeId> open;
    for (std::size_t e = 0; e < front.capacity(); ++e) {
      if (front[FrontEdgeId{e}].is_open) open.emplace_back(e);
    }
    return open;
  }
};

/// What holds between operations: the links, the half-edges, the count and the grid.
void check_front(const Plane& plane) {
  const SurfaceMesh& surface = plane.mesh.surface;
  const auto open = plane.open_edges();
  REQUIRE(open.size() == plane.front.open_edges());
  std::set<std::uint32_t> half_edges;
  for (const FrontEdgeId e : open) {
    const FrontEdge& edge = plane.front[e];
    REQUIRE(plane.front.next(e).is_open);
    REQUIRE(plane.front.previous(e).is_open);
    REQUIRE(plane.front.next(e).previous == e);
    REQUIRE(plane.front.previous(e).next == e);
    REQUIRE(surface.is_boundary(edge.half_edge));
    REQUIRE(surface.origin(edge.half_edge) == edge.origin);
    REQUIRE(surface.target(edge.half_edge) == plane.front.target(e));
    REQUIRE(edge.position == plane.mesh.position(edge.origin));
    half_edges.insert(edge.half_edge.value);
    bool is_filed = false;
    plane.front.grid().for_each_within(edge.position, 1, 0.01,
                                       [&](FrontEdgeId f) { is_filed = is_filed || f == e; });
    REQUIRE(is_filed);
  }
  std::size_t boundary = 0;
  for (std::uint32_t h = 0; h < 3 * surface.triangle_count(); ++h) {
    if (surface.is_boundary(HalfEdgeId{h})) {
      ++boundary;
      REQUIRE(half_edges.contains(h));
    }
  }
  REQUIRE(boundary == open.size());
}

/// A random walk of operations on the front that never lays an edge twice.
class Walk {
 public:
  Walk(Plane& plane, unsigned seed) : plane_(plane), random_(seed) {
    for (std::size_t t = 0; t < plane.mesh.surface.triangle_count(); ++t) note(t);
  }

  FrontEdgeId any() {
    const auto open = plane_.open_edges();
    return open[random_.below(open.size())];
  }
  void attach_new() {
    plane_.front.attach(any(), flat(random_.between(0, 1), random_.between(0, 1)));
    note_last();
  }
  bool close_corner() {
    const FrontEdgeId corner = any();
    const VertexId before = plane_.front.previous(corner).origin,
                   after = plane_.front.target(corner);
    const bool is_last =
        plane_.front[plane_.front.next(corner).next].origin == plane_.front[corner].origin &&
        plane_.front.next(corner).next == plane_.front[corner].previous;
    const bool is_three = plane_.front.next(plane_.front[corner].next).next == corner;
    if (!is_three && (before == after || is_edge(before, after) || is_last)) return false;
    plane_.front.close_corner(corner);
    note_last();
    return true;
  }
  /// Joins an edge with a corner elsewhere that `suits`.
  template <class Suits>
  bool attach_corner(Suits suits) {
    const FrontEdgeId e = any(), corner = any();
    const VertexId v = plane_.front[corner].origin;
    const VertexId p = plane_.front[e].origin, w = plane_.front.target(e);
    if (v == p || v == w || is_edge(p, v) || is_edge(w, v) || !suits(e, corner)) return false;
    plane_.front.attach(e, corner);
    note_last();
    return true;
  }
  bool is_same_polygon(FrontEdgeId e, FrontEdgeId f) const {
    FrontEdgeId g = e;
    do {
      if (g == f) return true;
      g = plane_.front[g].next;
    } while (g != e);
    return false;
  }
  /// Closes what is open, corner after corner; a new vertex now and then frees a polygon whose
  /// corners are all spoken for.
  void finish() {
    while (plane_.front.open_edges() > 0) {
      bool closed = false;
      for (int attempt = 0; attempt < 60 && !closed; ++attempt) closed = close_corner();
      if (!closed) attach_new();
    }
  }
  Random& random() { return random_; }

 private:
  bool is_edge(VertexId a, VertexId b) const {
    return edges_.contains(std::minmax(a.value, b.value));
  }
  void note_last() { note(plane_.mesh.surface.triangle_count() - 1); }
  void note(std::size_t t) {
    const auto [a, b, c] = plane_.mesh.surface.corners(geometry::TriangleId{t});
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      edges_.insert(std::minmax(p.value, q.value));
    }
  }

  Plane& plane_;
  Random random_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_;
};

long euler_characteristic(const SurfaceMesh& mesh) {
  return static_cast<long>(mesh.vertex_count()) - static_cast<long>(mesh.triangle_count() / 2);
}

}  // namespace

TEST_CASE("a front opened round a fan runs along its rim") {
  for (int n = 3; n < 9; ++n) {
    CAPTURE(n);
    Plane plane;
    const auto polygon = plane.fan(0, 0, 0.2, 0.1, n);
    CHECK(polygon.size() == static_cast<std::size_t>(n));
    CHECK(plane.front.open_edges() == polygon.size());
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      CHECK(plane.front[polygon[k]].next == polygon[(k + 1) % polygon.size()]);
    }
    check_front(plane);
  }
}

TEST_CASE(
    "new vertices, closed corners and splits keep the front sound, and it closes to a sphere") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Plane plane;
    plane.fan(0, 0, 0.2, 0);
    Walk walk(plane, seed);
    for (int step = 0; step < 40 && plane.front.open_edges() > 0; ++step) {
      CAPTURE(step);
      const double kind = walk.random().uniform();
      if (kind < 0.5) {
        walk.attach_new();
      } else if (kind < 0.8) {
        walk.close_corner();
      } else {
        walk.attach_corner(
            [&](FrontEdgeId e, FrontEdgeId c) { return walk.is_same_polygon(e, c); });
      }
      check_front(plane);
    }
    walk.finish();
    check_front(plane);
    CHECK(plane.front.open_edges() == 0);
    CHECK(geometry::validate(plane.mesh.surface).value_or("") == "");
    CHECK(euler_characteristic(plane.mesh.surface) == 2);
    CHECK(geometry::components(plane.mesh.surface).count == 1);
  }
}

TEST_CASE("two fronts that join become one, and close to one sphere") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Plane plane;
    const auto left = plane.fan(0, 0, 0.2, 0), right = plane.fan(0.6, 0, 0.2, M_PI, 5);
    Walk walk(plane, seed);
    CHECK_FALSE(walk.is_same_polygon(left[0], right[0]));
    while (!walk.attach_corner(
        [&](FrontEdgeId e, FrontEdgeId c) { return !walk.is_same_polygon(e, c); })) {
    }
    CHECK(walk.is_same_polygon(left[0], right[0]));
    CHECK(plane.front.open_edges() == left.size() + right.size() + 1);
    check_front(plane);
    walk.finish();
    check_front(plane);
    CHECK(geometry::validate(plane.mesh.surface).value_or("") == "");
    CHECK(euler_characteristic(plane.mesh.surface) == 2);
    CHECK(geometry::components(plane.mesh.surface).count == 1);
  }
}

TEST_CASE("a front that splits and joins again closes to a torus") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Plane plane;
    plane.fan(0, 0, 0.2, 0, 12);
    Walk walk(plane, seed);
    // Both parts must be long enough to be joined elsewhere.
    const auto length = [&](FrontEdgeId from, FrontEdgeId to) {
      int n = 0;
      for (FrontEdgeId e = from; e != to; e = plane.front[e].next) ++n;
      return n;
    };
    while (!walk.attach_corner(
        [&](FrontEdgeId e, FrontEdgeId c) { return length(e, c) >= 5 && length(c, e) >= 5; })) {
    }
    check_front(plane);
    while (!walk.attach_corner(
        [&](FrontEdgeId e, FrontEdgeId c) { return !walk.is_same_polygon(e, c); })) {
    }
    check_front(plane);
    walk.finish();
    CHECK(geometry::validate(plane.mesh.surface).value_or("") == "");
    CHECK(euler_characteristic(plane.mesh.surface) == 0);
  }
}

TEST_CASE(
    "a loop that a touch split off is futile if it closes alone, and not if it meets the front") {
  struct Watch : FrontMirror {
    TouchLoops loops;
    bool is_predicted = true;
    void follow(const FrontChange& change) override { loops.follow(change, is_predicted); }
  };
  for (unsigned seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const bool meets = seed % 2 == 1, has_maximum = seed % 3 == 0;
    Watch watch;
    Plane plane;
    plane.front.add_mirror(watch);
    const auto polygon = plane.fan(0, 0, 0.2, 0, 14);
    // Five edges are split off; the other part has eight and a new one.
    plane.front.attach(polygon[0], polygon[6]);
    if (has_maximum) watch.loops.note_maximum(polygon[1]);
    watch.is_predicted = false;
    if (meets) plane.front.attach(polygon[9], polygon[3]);
    Walk walk(plane, seed);
    walk.finish();
    CHECK(watch.loops.futile(true) == (meets || has_maximum ? 0U : 1U));
    CHECK(watch.loops.futile(false) == 0);
  }
}

TEST_CASE("a reused front edge has a new generation") {
  Plane plane;
  const auto polygon = plane.fan(0, 0, 0.2, 0);
  const std::uint32_t before = plane.front[polygon[2]].generation;
  plane.front.close_corner(polygon[2]);
  CHECK_FALSE(plane.front[polygon[2]].is_open);
  const FrontEdgeId added = plane.front.attach(polygon[0], flat(0.5, 0.5));
  CHECK(added == polygon[2]);
  CHECK(plane.front[added].generation > before);
}

TEST_CASE(
    "the grid finds within reach just what a look at all corners finds, over six orders of "
    "length") {
  std::size_t found_in_all = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    // A length scale that changes no faster than the point moves, smallest at a few places.
    std::vector<std::pair<Point, double>> deepest;
    for (int i = 0; i < 4; ++i) {
      deepest.emplace_back(random.between(0, 2) * random.direction(),
                           std::pow(10.0, random.between(-6, 0)));
    }
    const auto length_scale = [&](const Point& x) {
      double least = INFINITY;
      for (const auto& [at, scale] : deepest) least = std::min(least, scale + (x - at).norm());
      return least;
    };
    const auto random_point = [&]() -> Point {
      const auto& [at, scale] = deepest[random.below(deepest.size())];
      return at + scale * std::pow(10.0, random.between(-1, 1)) * random.direction();
    };
    FrontGrid grid(seed % 2 == 0 ? 0.4 : 0.85);  // in two bands at most, or in three
    struct Filed {
      FrontEdgeId corner;
      Point position;
      FrontGrid::Keys keys;
    };
    std::vector<Filed> filed;
    for (std::uint32_t i = 0; i < 3000; ++i) {
      if (random.uniform() < 0.35 && !filed.empty()) {
        const std::size_t k = random.below(filed.size());
        grid.erase(filed[k].corner, filed[k].keys);
        filed[k] = filed.back();
        filed.pop_back();
      } else {
        const Point x = random_point();
        filed.push_back({FrontEdgeId{i}, x, grid.insert(FrontEdgeId{i}, x, length_scale(x))});
      }
      if (i % 30 != 0) continue;
      CAPTURE(i);
      const Point p = random_point();
      const double rho = length_scale(p);
      const double reach = random.between(0, grid.max_radius(rho));
      std::vector<FrontEdgeId> visited, expected;
      grid.for_each_within(p, rho, reach, [&](FrontEdgeId e) { visited.push_back(e); });
      std::sort(visited.begin(), visited.end());
      visited.erase(std::unique(visited.begin(), visited.end()), visited.end());
      // Single precision offsets: a thousandth of the reach, a millionth of the scale.
      const double beyond = reach * 1.001 + 1e-5 * rho;
      for (const auto& [e, x, keys] : filed) {
        const double d = (x - p).norm();
        const bool is_visited = std::binary_search(visited.begin(), visited.end(), e);
        if (d <= reach * (1 - 1e-6)) CHECK(is_visited);
        if (d > beyond) CHECK_FALSE(is_visited);
        if (is_visited) expected.push_back(e);
      }
      CHECK(expected.size() == visited.size());  // nothing erased is visited
      found_in_all += visited.size();
    }
  }
  CHECK(found_in_all > 1000);
}

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
  for (unsigned seed = 0; seed < 500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
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
    if (!apex) continue;
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
  }
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
  for (unsigned seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    Random random(seed);
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
  }
}
