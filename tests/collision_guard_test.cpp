// The collision guard: its five conditions, and the pass that asks for all of them at once.

#include "front/neighbourhood.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::front;
using namespace morskin::support;

namespace {

/// A point of a flat skin, the plane z = 0 with length scale 1, or a little beside it.
SurfacePoint flat(double x, double y, double z = 0) {
  return {{x, y, z}, Vector::UnitZ(), 1, geometry::CellId{}};
}

/// Fans of five to seven triangles strewn over the plane, some over others, with further triangles
/// on a few of their edges: a front as it should never be.
void lay_anywhere(Front& front, Random& random) {
  for (int fan = 0; fan < 6; ++fan) {
    const double x = random.between(-0.3, 0.3), y = random.between(-0.3, 0.3);
    const double radius = random.between(0.03, 0.12), turn = random.between(0, 3);
    const std::size_t n = 5 + random.below(3);
    std::vector<SurfacePoint> rim;
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = turn + 2 * M_PI * static_cast<double>(k) / static_cast<double>(n);
      rim.push_back(flat(x + radius * std::cos(angle), y + radius * std::sin(angle),
                         random.between(-0.01, 0.01)));
    }
    front.open_fan(flat(x, y), rim);
  }
  for (int i = 0; i < 8; ++i) {
    const FrontEdgeId e{random.below(front.capacity())};
    front.attach(e, flat(random.between(-0.3, 0.3), random.between(-0.3, 0.3)));
  }
}

}  // namespace

TEST_CASE("a new vertex is clear if and only if it meets all five conditions of the guard") {
  std::size_t clear = 0;
  std::array<std::size_t, 5> broken_alone{};
  for_seeds<Random>(300, [&](Random& random) {
    surface::Mesh mesh;
    Front front(mesh);
    lay_anywhere(front, random);
    Neighbourhood guard(mesh, front);
    guard.gather(flat(0, 0));
    for (int i = 0; i < 200; ++i) {
      CAPTURE(i);
      const FrontEdgeId e{random.below(front.capacity())};
      const Vector along = front.next(e).position - front[e].position;
      const Vector right(along.y(), -along.x(), 0);
      const LocalPoint x = guard.local(front[e].position + random.between(-0.5, 1.5) * along +
                                       random.between(-0.1, 1.5) * right);
      const double vertex_gap = random.between(0, 0.04), edge_gap = random.between(0, 0.03);
      const std::array holds{guard.is_high(e, x), guard.keeps_distance(e, x, vertex_gap, edge_gap),
                             guard.has_empty_circle(e, x), guard.crosses_no_edge(e, x),
                             guard.is_uncovered(e, x)};
      const auto broken = std::count(holds.begin(), holds.end(), false);
      CHECK(guard.is_clear(e, x, vertex_gap, edge_gap) == (broken == 0));
      clear += broken == 0;
      for (std::size_t k = 0; k < 5; ++k) broken_alone[k] += broken == 1 && !holds[k];
    }
  });
  CHECK(clear > 1000);
  for (const std::size_t alone : broken_alone) CHECK(alone > 20);
}
