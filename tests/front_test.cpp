#include "front/front.h"

#include "front/operation_counter.h"
#include "tests/support/meshes.h"
#include "tests/support/plane_front.h"

using namespace morskin;
using namespace morskin::front;
using namespace morskin::support;
using geometry::SurfaceMesh;

namespace {

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

/// Closes what is open and checks what it closes to.
void finish(Plane& plane, Walk& walk, long euler_characteristic) {
  walk.finish();
  check_front(plane);
  CHECK(geometry::validate(plane.mesh.surface).value_or("") == "");
  CHECK(support::euler_characteristic(plane.mesh.surface) == euler_characteristic);
  CHECK(geometry::components(plane.mesh.surface).count == 1);
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
  for_seeds(200, [&](unsigned seed) {
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
    finish(plane, walk, 2);
    CHECK(plane.front.open_edges() == 0);
  });
}

TEST_CASE("two fronts that join become one, and close to one sphere") {
  for_seeds(200, [&](unsigned seed) {
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
    finish(plane, walk, 2);
  });
}

TEST_CASE("a front that splits and joins again closes to a torus") {
  for_seeds(200, [&](unsigned seed) {
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
    finish(plane, walk, 0);
  });
}

TEST_CASE(
    "a loop that a touch split off is futile if it closes alone, and not if it meets the front") {
  struct Watch : FrontMirror {
    TouchLoops loops;
    bool is_predicted = true;
    void follow(const FrontChange& change) override { loops.follow(change, is_predicted); }
  };
  for_seeds(100, [&](unsigned seed) {
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
  });
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

TEST_CASE("a step notes the corners at a triangle's apex, or on both sides of one that closed") {
  struct Watch : FrontMirror {
    std::set<FrontEdgeId> noted;
    void follow(const FrontChange& change) override {
      noted = {change.corners.begin(), change.corners.end()};
    }
  };
  using Corners = std::set<FrontEdgeId>;
  Watch watch;
  Plane plane;
  plane.front.add_mirror(watch);
  const auto polygon = plane.fan(0, 0, 0.2, 0, 12);
  CHECK(watch.noted == Corners(polygon.begin(), polygon.end()));
  CHECK(watch.noted.contains(plane.front.attach(polygon[0], flat(0.3, 0.1))));
  CHECK(watch.noted.size() == 1);
  const FrontEdgeId split = plane.front.attach(polygon[2], polygon[7]);
  CHECK(watch.noted == Corners{split, polygon[7]});
  plane.front.close_corner(polygon[4]);
  CHECK(watch.noted == Corners{polygon[3], polygon[5]});
}
