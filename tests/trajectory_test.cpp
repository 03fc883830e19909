#include "bench/baselines/trajectory.h"

#include "morskin/pipeline.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::baselines;
using namespace morskin::support;

namespace {

/// A point of the growing skin somewhere about the balls, its time and its cell; nothing when the
/// sample is too near a critical point to follow it numerically.
struct Start {
  Point x;
  CellId cell;
  double time;
};
std::optional<Start> random_start(const SkinSurface& skin, Random& random) {
  const Box box = box_of(skin.points());
  const Point x = box.sample(random);
  const CellId cell = skin.locate(x, CellId{});
  const Patch& patch = skin.patch(cell);
  if (patch.length_scale(x) < 0.05) return std::nullopt;
  return Start{x, cell, 2 * patch.value(x)};
}

/// dx / dt = N / (4 rho^2), by the classical Runge-Kutta method.
Point followed_numerically(const SkinSurface& skin, Start start, double end) {
  const auto velocity = [&](const Point& x) {
    start.cell = skin.locate(x, start.cell);
    const Vector n = skin.patch(start.cell).half_gradient(x);
    return Vector(n / (4 * n.squaredNorm()));
  };
  constexpr int steps = 2000;
  const double h = (end - start.time) / steps;
  Point x = start.x;
  for (int i = 0; i < steps; ++i) {
    const Vector a = velocity(x), b = velocity(x + h / 2 * a), c = velocity(x + h / 2 * b);
    const Vector d = velocity(x + h * c);
    x += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return x;
}

}  // namespace

TEST_CASE("a trajectory is the numerical solution of its equation, over cell walls too") {
  std::size_t followed = 0, crossings = 0;
  for_skins(60, [&](unsigned seed, const PreparedSkin& skin) {
    Random random(seed);
    for (int i = 0; i < 3; ++i) {
      const auto start = random_start(skin.surface, random);
      if (!start) continue;
      const double rho = skin.surface.patch(start->cell).length_scale(start->x);
      const double end = start->time + random.between(0.1, 1.5) * rho * rho;
      const Trajectory path(skin.surface, start->x, start->cell, start->time);
      const Trajectory last = path.followed_to(skin.surface, end);
      const SurfacePoint there = last.at(skin.surface, end);
      if (there.length_scale < 0.1 * rho) continue;
      const Point expected = followed_numerically(skin.surface, *start, end);
      CHECK((there.position - expected).norm() < 1e-5 * rho);
      ++followed;
      crossings += last.cell() != path.cell();
    }
  });
  CHECK(followed > 100);
  CHECK(crossings > 30);
}

TEST_CASE("a trajectory stays on the growing skin, in the cell it names") {
  for_skins(200, [&](unsigned seed, const PreparedSkin& skin) {
    Random random(seed + 1000);
    const auto start = random_start(skin.surface, random);
    if (!start) return;
    Trajectory path(skin.surface, start->x, start->cell, start->time);
    double t = start->time;
    for (int i = 0; i < 10; ++i) {
      const double rho = path.at(skin.surface, t).length_scale;
      t += 0.4 * rho * rho;
      path = path.followed_to(skin.surface, t);
      const SurfacePoint p = path.at(skin.surface, t);
      const LevelSet level(skin.surface, t);
      CHECK(std::abs(level.patch(p.cell).value(p.position)) <=
            10 * level.residual_bound(p.length_scale));
      for (const skin::Wall& wall : skin.surface.complex().walls(p.cell)) {
        CHECK(wall.normal.dot(p.position) - wall.offset <= 1e-9);
      }
    }
  });
}

TEST_CASE("the length scale changes by at most half the time, squared") {
  for_skins(100, [&](unsigned seed, const PreparedSkin& skin) {
    Random random(seed + 2000);
    const auto start = random_start(skin.surface, random);
    if (!start) return;
    const Trajectory path(skin.surface, start->x, start->cell, start->time);
    const double before = path.at(skin.surface, start->time).length_scale;
    const double dt = random.uniform() * before * before;
    const double after = path.followed_to(skin.surface, start->time + dt)
                             .at(skin.surface, start->time + dt)
                             .length_scale;
    CHECK(std::abs(after * after - before * before) <= dt / 2 + 1e-9);
  });
}

TEST_CASE("the skin at a time is the skin of balls with that much more weight") {
  std::size_t compared = 0;
  for_seeds<Random>(50, [&](unsigned seed, Random& random) {
    const auto points = ball_set(seed);
    const auto skin = prepared(points);
    if (!skin) return;
    auto grown = points;
    for (auto& p : grown) p.weight += 0.25;
    const auto later = prepared(grown);
    if (!later) return;
    const LevelSet level(skin->surface, 0.25);
    for (int i = 0; i < 20; ++i) {
      const auto before = skin->surface.project(box_of(points).sample(random), CellId{});
      if (!before || before->length_scale < 0.5) continue;  // it moves by 0.25 / (4 rho)
      const auto one = level.project(before->position, before->cell);
      const auto other = later->surface.project(before->position, CellId{});
      REQUIRE(one.has_value() == other.has_value());
      if (!one) continue;
      ++compared;
      CHECK((one->position - other->position).norm() < 1e-7);
      CHECK(one->length_scale == doctest::Approx(other->length_scale).epsilon(1e-6));
    }
  });
  CHECK(compared > 500);
}
