// Origins of a squared distance from which critical points are not isolated, and that it is said
// so.

#include "morse/cell_contact.h"
#include "morse/critical_points.h"
#include "skin/dual_complex.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;
using skin::CellId;
using skin::SkinSurface;

namespace {

bool mentions(const CriticalPoints& critical, std::string_view words) {
  return std::any_of(critical.degeneracies.begin(), critical.degeneracies.end(),
                     [&](const std::string& text) { return contains(text, words); });
}

/// Two balls of patch radius 1 and the edge between them along x, 2 half apart.
SkinSurface pair(double half) { return SkinSurface({ball(-half, 0, 0, 1), ball(half, 0, 0, 1)}); }

CriticalPoints from(const SkinSurface& skin, const Point& origin) {
  return critical_points(skin, MorseFunction::squared_distance(origin));
}

void check_isolated(const CriticalPoints& critical, long euler_characteristic) {
  CHECK(critical.degeneracies.empty());
  CHECK(critical.euler_characteristic() == euler_characteristic);
}

}  // namespace

TEST_CASE(
    "on lattices of balls, heights and distances of symmetry are degenerate or have the right "
    "sum") {
  std::size_t asked = 0, degenerate = 0;
  for_seeds<Random>(300, [&](Random& random) {
    const auto lattice = [&](double step) {
      Point x;
      for (Eigen::Index k = 0; k < 3; ++k) x[k] = step * static_cast<double>(random.below(5));
      return x;
    };
    WeightedPoints points(2 + random.below(20));
    for (auto& p : points) p = {lattice(1), random.below(2) ? 0.9 : 2.1};
    const SkinSurface skin(points);
    const long chi = skin::dual_complex(skin).skin_euler_characteristic();
    const skin::MixedComplex& complex = skin.complex();
    for (int i = 0; i < 20; ++i) {
      const skin::Patch& patch = complex.patch(CellId{random.below(complex.size())});
      // A lattice point, a centre of a patch, a point of its axis; exact or up to rounding.
      Point origin =
          std::array<Point, 3>{lattice(0.5), patch.centre,
                               patch.centre + random.between(-3, 3) * patch.axis}[random.below(3)];
      if (random.below(2)) origin += std::pow(10, -random.between(0, 17)) * random.direction();
      const Vector direction = lattice(1) - Vector(2, 2, 2);
      for (const bool is_height : {false, true}) {
        if (is_height && direction.isZero()) continue;
        const auto critical =
            critical_points(skin, is_height ? MorseFunction::height(direction)
                                            : MorseFunction::squared_distance(origin));
        ++asked;
        degenerate += !critical.degeneracies.empty();
        if (critical.degeneracies.empty()) CHECK(critical.euler_characteristic() == chi);
      }
    }
  });
  CHECK(degenerate > 1000);
  CHECK(degenerate < asked / 2);
}

TEST_CASE("distances from a lone ball's centre are degenerate, a little off they are not") {
  const SkinSurface one({ball(1, 2, 3, 1.5)});
  CHECK(mentions(from(one, {1, 2, 3}), "patch of critical points"));
  CHECK(mentions(from(one, {1 + 1e-15, 2, 3}), "patch of critical points"));
  CHECK(from(one, {1 + 1e-9, 2, 3}).degeneracies.empty());
}

TEST_CASE("the centre of an atom is degenerate just when its sphere has a part in the skin") {
  std::size_t exposed = 0, buried = 0;
  for_seeds<Random>(400, [&](unsigned seed, Random& random) {
    const SkinSurface skin(ball_set(seed));
    const std::size_t atom = random.below(skin.triangulation().vertices.size());
    const CellId cell = skin.complex().cell(0, atom);
    const skin::Patch& patch = skin.complex().patch(cell);
    bool is_exposed = false;
    for (int i = 0; i < 2000 && !is_exposed; ++i) {
      const Point x = patch.centre + std::sqrt(patch.half_weight) * random.direction();
      is_exposed = side(skin.complex(), cell, x, 0) == Where::Inside;
    }
    const auto critical = from(skin, patch.centre);
    const bool is_reported = mentions(critical, "patch of critical points");
    if (is_exposed) CHECK(is_reported);
    exposed += is_reported;
    if (critical.degeneracies.empty()) {
      ++buried;
      CHECK(critical.euler_characteristic() ==
            skin::dual_complex(skin).skin_euler_characteristic());
    }
  });
  CHECK(exposed > 100);
  CHECK(buried > 30);
}

TEST_CASE("distances from a point on a pair's axis have a circle of critical points, off it none") {
  const SkinSurface neck = pair(1);
  for (const double x : {0.0, 0.3, 0.9}) {
    CAPTURE(x);
    CHECK(mentions(from(neck, {x, 0, 0}), "circle of critical points"));
    for (const double off : {1e-9, 1e-3}) check_isolated(from(neck, {x, off, 0.0}), 2);
  }
  // From far out on the axis the circle that solves the neck's equation is beyond its cell.
  const auto far = from(neck, {20, 0, 0});
  CHECK_FALSE(mentions(far, "circle"));
  CHECK(far.degeneracies.empty());
  CHECK(far.points.size() == 2);
}

TEST_CASE("the axis may run in any direction: rounding does not hide the circle") {
  for_seeds<Random>(100, [&](Random& random) {
    const auto on_grid = [](const Vector& v) -> Vector {
      return v.unaryExpr(&geometry::on_exact_grid);
    };
    const Point middle = on_grid(random.between(0, 50) * random.direction());
    const Vector half = on_grid(random.direction());
    const SkinSurface skin({{middle - half, 2}, {middle + half, 2}});
    CHECK(mentions(from(skin, middle + 0.3 * half), "circle of critical points"));
  });
}

TEST_CASE("distances from the centre of curvature at the tip of a cap have a singular Hessian") {
  // The gap of two caps: half apart squared 3.0625, weights 2, so w/2 = -0.53125; the tips lie at
  // its root, the centres of curvature twice as far.
  const SkinSurface caps = pair(1.75);
  const double tip = std::sqrt(0.53125);
  CHECK(mentions(from(caps, {2 * tip, 0, 0}), "Hessian is singular"));
  for (const double x : {2 * tip - 1e-3, 2 * tip + 1e-3}) {
    check_isolated(from(caps, {x, 1e-4, 0}), 4);
  }
}

TEST_CASE("where an origin crosses a neck's evolute two critical points meet, and it is said so") {
  const SkinSurface skin = pair(1);
  const CellId neck = skin.complex().cell(1, 0);
  const skin::Patch& patch = skin.complex().patch(neck);
  const double radius_squared = patch.half_weight;
  for (const double along : {0.1, 0.2, 0.3, 0.4}) {
    CAPTURE(along);
    const Point x(along, std::sqrt(radius_squared + along * along), 0);
    // Curvature of the meridian: w/2 over |u|^3; it bends away from the axis.
    const double bend = std::pow(x.norm(), 3) / radius_squared;
    const auto at = [&](double share) -> Point { return x + share * bend * patch.normal(x); };
    CHECK(mentions(from(skin, at(1)), "Hessian is singular"));
    const auto nearer = from(skin, at(0.99)), farther = from(skin, at(1.01));
    check_isolated(nearer, 2);
    check_isolated(farther, 2);
    CHECK(farther.points.size() == nearer.points.size());
    // The normal touches the evolute; across it the pair appears. The step is small against the
    // evolute's two branches, which are near each other where `along` is small.
    const Vector step = 1e-4 * Vector::UnitZ().cross(patch.normal(x));
    const auto one = from(skin, at(1) + step), other = from(skin, at(1) - step);
    CHECK(std::max(one.points.size(), other.points.size()) ==
          std::min(one.points.size(), other.points.size()) + 2);
    CHECK(one.euler_characteristic() == 2);
    CHECK(other.euler_characteristic() == 2);
  }
}
