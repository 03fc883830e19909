#include "skin/skin_components.h"

#include "skin/skin_surface.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::skin;
using geometry::CellId;
using geometry::Point;
using geometry::Vector;
using surface::SurfacePoint;
using Sides = SkinComponents::Sides;

namespace {

/// Where G leads from a point, up or down: the cell of a critical point, or infinity.
struct FlowEnd {
  CellId cell;
  bool is_at_infinity = false;
};

/// On a step by t N, t < 2, G never comes back (N changes by no more than the distance): the points
/// stay on their side of the skin. They are drawn to minima, or maxima, and to nothing else.
std::optional<FlowEnd> flow_end(const SkinSurface& skin, Point x, CellId cell, bool is_up) {
  constexpr double step = 0.75, still = 1e-9;
  const surface::BoundingBall all = skin.bounding_ball();
  for (int k = 0; k < 2000; ++k) {
    cell = skin.locate(x, cell);
    const Vector n = skin.patch(cell).half_gradient(x);
    if ((x - all.centre).norm() > 3 * all.radius) return FlowEnd{cell, true};
    if (n.norm() < still * all.radius) return FlowEnd{cell, false};
    x += (is_up ? step : -step) * n;
  }
  return std::nullopt;
}

/// The void, or nothing for the outside; of a point of the complement.
std::optional<std::uint32_t> void_by_flow(const PreparedSkin& skin, const FlowEnd& end) {
  if (end.is_at_infinity) return std::nullopt;
  const auto index = skin.surface.complex().simplex_index(end.cell);
  const std::uint32_t part = skin.topology.void_of_tetrahedron[index];
  return part == DualComplex::no_part ? std::nullopt : std::optional(part);
}

std::optional<Sides> sides_by_flow(const PreparedSkin& skin, const SurfacePoint& x) {
  const auto down = flow_end(skin.surface, x.position, x.cell, false);
  const auto up = flow_end(skin.surface, x.position, x.cell, true);
  const MixedComplex& complex = skin.surface.complex();
  if (!down || !up || complex.dimension(down->cell) != 0) return std::nullopt;
  if (!up->is_at_infinity && complex.dimension(up->cell) != 3) return std::nullopt;
  return Sides{skin.topology.body_of_vertex[complex.simplex_index(down->cell)],
               void_by_flow(skin, *up)};
}

/// Four balls whose tetrahedron has its orthocentre near its middle: apart, a frame, or a cage.
std::vector<geometry::WeightedPoint> four_balls(unsigned seed) {
  support::Random random(seed);
  std::vector<geometry::WeightedPoint> points = support::tetrahedron_balls(0);
  const double share = random.between(0.5, 1);  // of the power that the centre has at the corners
  for (auto& p : points) {
    const Point at = p.position + 0.3 * random.in_cube(-1, 1);
    p = {at.unaryExpr(&geometry::on_exact_grid),
         geometry::on_exact_grid(share * 3 * random.between(0.9, 1.1))};
  }
  return points;
}

/// Balls on a cubic grid, which most often close eight voids between them.
std::vector<geometry::WeightedPoint> eight_cages(unsigned seed) {
  support::Random random(seed);
  support::Balls balls;
  for (int k = 0; k < 27; ++k) {
    const Point corner(k % 3, k / 3 % 3, k / 9);
    balls.push_back({corner + 0.05 * random.in_cube(-1, 1), random.between(0.54, 0.58)});
  }
  return support::weighted(balls);
}

std::vector<geometry::WeightedPoint> any_balls(unsigned seed) {
  switch (seed % 4) {
    case 0:
      return four_balls(seed);
    case 1:
      return eight_cages(seed);
    case 2:
      return support::ball_set(seed);
    default:
      return support::nasty_set(seed);
  }
}

/// Calls visit(skin, parts, x) with points in and about so many sets' skins.
template <class Visit>
void for_points(unsigned sets, Visit visit) {
  support::for_seeds(sets, [&](unsigned seed) {
    const auto skin = support::prepared(any_balls(seed));
    if (!skin) return;
    const SkinComponents parts(skin->surface, skin->topology);
    const surface::BoundingBall all = skin->surface.bounding_ball();
    support::Random random(seed);
    for (int k = 0; k < 60; ++k) {
      visit(*skin, parts, Point(all.centre + all.radius * random.uniform() * random.direction()));
    }
  });
}

}  // namespace

TEST_CASE("a point of the skin lies between the parts to which the gradient leads from it") {
  std::size_t in_voids = 0, in_tetrahedra = 0, lost = 0;
  for_points(600, [&](const auto& skin, const SkinComponents& parts, const Point& from) {
    const SkinSurface& surface = skin.surface;
    const auto x = surface.project(from, surface.locate(from, CellId{0U}));
    const auto expected = x ? sides_by_flow(skin, *x) : std::nullopt;
    if (!expected) return;
    const auto found = parts.sides(*x);
    lost += !found;
    if (found) CHECK(found == expected);
    in_voids += expected->cavity.has_value();
    in_tetrahedra += surface.complex().dimension(x->cell) == 3 && skin.topology.bodies.size() > 1;
  });
  CHECK(lost < 10);  // by rounding, in lattices
  CHECK(in_voids > 1000);
  CHECK(in_tetrahedra > 50);
}

TEST_CASE("a point of the complement lies in the void to which the gradient leads up from it") {
  std::size_t in_voids = 0, outside = 0;
  for_points(300, [&](const auto& skin, const SkinComponents& parts, const Point& x) {
    const SkinSurface& surface = skin.surface;
    const CellId cell = surface.locate(x, CellId{0U});
    if (!(surface.enclose(x, cell).low > 0)) return;
    const auto up = flow_end(surface, x, cell, true);
    if (!up || (!up->is_at_infinity && surface.complex().dimension(up->cell) != 3)) return;
    const auto expected = void_by_flow(skin, *up);
    CHECK(parts.void_at(x, cell) == expected);
    ++(expected ? in_voids : outside);
  });
  CHECK(in_voids > 100);
  CHECK(outside > 1000);
}

TEST_CASE("at a waist, as near to both balls, a point lies on the body of both") {
  const auto skin = support::prepared({{{-1, 0, 0}, 2}, {{1, 0, 0}, 2}});
  REQUIRE(skin);
  const auto x = skin->surface.project({0, 1, 0}, skin->surface.locate({0, 1, 0}, CellId{0U}));
  REQUIRE(x);
  CHECK(x->position.x() == 0);
  CHECK(SkinComponents(skin->surface, skin->topology).sides(*x) == Sides{0, std::nullopt});
}

TEST_CASE("from any ball of a row, each covered by a larger one, the way to the body is found") {
  // At z the weight is a z^2 - 1; balls below z = 1 / sqrt(1 - a) are not in K. The way from one
  // goes to about 2 z.
  std::vector<geometry::WeightedPoint> row;
  constexpr double a = 1 - 1e-8;
  for (double z = 1.2; z < 13'000; z *= 1.25) row.push_back({{z, 0, 0}, a * z * z - 1});
  const auto skin = support::prepared(row);
  REQUIRE(skin);
  REQUIRE(skin->topology.betti == std::array<std::size_t, 3>{1, 0, 0});
  const SkinComponents components(skin->surface, skin->topology);
  const surface::Samples samples = skin->surface.samples();
  REQUIRE(samples.points.size() > 20);
  for (const SurfacePoint& x : samples.points) {
    CHECK(components.sides(x) == Sides{0, std::nullopt});
  }
}
