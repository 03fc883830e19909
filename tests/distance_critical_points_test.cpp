#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "morse/cell_contact.h"
#include "morse/critical_points.h"
#include "skin/dual_complex.h"
#include "tests/support/molecules.h"

using namespace morskin;
using namespace morskin::morse;
using skin::CellId;
using skin::SkinSurface;
using support::ball;

namespace {

Point on_patch(const skin::Patch& patch, Point x) {
  for (int round = 0; round < 20; ++round) x = patch.slide(x);
  return x;
}

bool mentions(const CriticalPoints& critical, std::string_view words) {
  return std::any_of(critical.degeneracies.begin(), critical.degeneracies.end(),
                     [&](const std::string& text) { return text.find(words) != text.npos; });
}

/// A random ball set, and an origin of the distance: among the balls, outside, far away, or within
/// 1 to 1e-8 Angstrom of the skin.
struct Case {
  explicit Case(unsigned seed)
      : random(seed), skin(support::ball_set(seed)), box(support::box_of(skin.points())) {
    const double span = support::span_of(box);
    const Point middle = (box.low + box.high) / 2;
    origin = box.sample(random);
    if (seed % 4 == 1) origin = middle + random.between(0.5, 3) * span * random.direction();
    if (seed % 4 == 2) {
      origin = middle + std::pow(10, random.between(1, 6)) * span * random.direction();
    }
    if (seed % 4 == 3) {
      const auto near = skin.project(origin, CellId{0U});
      if (near) {
        origin = near->position + std::pow(10, -random.between(0, 8)) * random.direction();
      }
    }
    critical = critical_points(skin, MorseFunction::squared_distance(origin));
  }
  bool is_degenerate() const { return !critical.degeneracies.empty(); }

  support::Random random;
  SkinSurface skin;
  support::Box box;
  Point origin;
  CriticalPoints critical;
};

/// Two balls of patch radius 1 and the edge between them along x, 2 half apart.
SkinSurface pair(double half) { return SkinSurface({ball(-half, 0, 0, 1), ball(half, 0, 0, 1)}); }

CriticalPoints from(const SkinSurface& skin, const Point& origin) {
  return critical_points(skin, MorseFunction::squared_distance(origin));
}

}  // namespace

TEST_CASE("every critical point of a distance lies on the skin, its normal towards the origin") {
  for (unsigned seed = 0; seed < 600; ++seed) {
    CAPTURE(seed);
    const Case test(seed);
    for (const CriticalPoint& p : test.critical.points) {
      const surface::SurfacePoint& x = p.point;
      const CellId cell = test.skin.locate(x.position, x.cell);
      const double rho = x.length_scale;
      const double off = 1e-10 * rho + test.skin.complex().wall_tolerance();
      CHECK(std::abs(test.skin.complex().patch(cell).value(x.position)) <= 2 * rho * off);
      const surface::SurfacePoint there = test.skin.at(x.position, cell);
      CHECK((there.normal - x.normal).norm() <= 4 * off / rho);
      CHECK(std::abs(there.length_scale - rho) <= 4 * off);
      // The part of x - p in the tangent plane, against the rounding of the places and, near a
      // small length scale, of the normal.
      const Vector towards = x.position - test.origin;
      const double size = x.position.norm() + test.origin.norm();
      CHECK((towards - towards.dot(x.normal) * x.normal).norm() <=
            1e-14 * size + 4 * off / rho * towards.norm());
      CHECK(p.value == towards.squaredNorm());
    }
  }
}

TEST_CASE("the index counts the descending directions of differences of the squared distance") {
  std::array<std::size_t, 3> met{};
  for (unsigned seed = 0; seed < 600; ++seed) {
    CAPTURE(seed);
    const Case test(seed);
    for (const CriticalPoint& p : test.critical.points) {
      const skin::Patch& patch = test.skin.complex().patch(p.point.cell);
      const Point& x = p.point.position;
      const double rho = p.point.length_scale, h = 1e-3 * rho;
      const double scale = 2 * (1 + (x - test.origin).norm() / rho);  // of the Hessian
      // Rounding moves a step by 1e-15 of the coordinates; over h^2 it must stay below `flat`.
      constexpr double flat = 1e-3;
      if (1e-15 * (x.norm() + test.origin.norm()) > 0.1 * flat * 1e-6 * rho) continue;
      const auto rise = [&](const Vector& step) {
        const Point y = on_patch(patch, x + h * step);
        return (y - x).dot((y - test.origin) + (x - test.origin)) / (h * h * scale);
      };
      const Vector e = p.point.normal.unitOrthogonal(), f = p.point.normal.cross(e);
      const double ee = rise(e) + rise(-e), ff = rise(f) + rise(-f);
      const double ef = (rise(e + f) + rise(-e - f) - rise(e - f) - rise(f - e)) / 4;
      Eigen::Matrix2d hessian;
      hessian << ee, ef, ef, ff;
      const Eigen::Vector2d values =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(hessian).eigenvalues();
      if (values.cwiseAbs().minCoeff() < flat) continue;
      ++met[static_cast<std::size_t>(p.index)];
      CHECK(p.index == (values[0] < 0) + (values[1] < 0));
      if (p.index != 1) {
        CHECK(p.descending == Vector::Zero());
        CHECK(p.ascending == Vector::Zero());
        continue;
      }
      for (const Vector& direction : {p.descending, p.ascending}) {
        CHECK(std::abs(direction.norm() - 1) < 1e-12);
        CHECK(std::abs(direction.dot(p.point.normal)) < 1e-12);
      }
      CHECK(std::abs(p.descending.dot(p.ascending)) < 1e-12);
      // They are the Hessian's own directions: its values are the second differences along them.
      CHECK(rise(p.descending) + rise(-p.descending) == doctest::Approx(values[0]).epsilon(flat));
      CHECK(rise(p.ascending) + rise(-p.ascending) == doctest::Approx(values[1]).epsilon(flat));
    }
  }
  for (const std::size_t count : met) CHECK(count > 500);
}

TEST_CASE("minima - saddles + maxima of a distance is the skin's Euler characteristic") {
  std::size_t asked = 0, degenerate = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    CAPTURE(seed);
    const Case test(seed);
    ++asked;
    if (test.is_degenerate()) {
      ++degenerate;
      continue;
    }
    CHECK(test.critical.euler_characteristic() ==
          skin::dual_complex(test.skin).skin_euler_characteristic());
  }
  CHECK(100 * degenerate < asked);
}

TEST_CASE(
    "on lattices of balls, heights and distances of symmetry are degenerate or have the right "
    "sum") {
  std::size_t asked = 0, degenerate = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const auto lattice = [&](double step) {
      Point x;
      for (Eigen::Index k = 0; k < 3; ++k) x[k] = step * static_cast<double>(random.below(5));
      return x;
    };
    support::WeightedPoints points(2 + random.below(20));
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
  }
  CHECK(degenerate > 1000);
  CHECK(degenerate < asked / 2);
}

TEST_CASE("no point of the skin is nearer than the nearest minimum or farther than any maximum") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    Case test(seed);
    if (test.is_degenerate()) continue;
    double nearest = INFINITY, farthest = 0;
    for (const CriticalPoint& p : test.critical.points) {
      if (p.index == 0) nearest = std::min(nearest, std::sqrt(p.value));
      if (p.index == 2) farthest = std::max(farthest, std::sqrt(p.value));
    }
    const double rounding = 1e-10 * (support::span_of(test.box) + test.origin.norm());
    for (int i = 0; i < 100; ++i) {
      const auto x = test.skin.project(test.box.sample(test.random), CellId{0U});
      if (!x) continue;
      const double distance = (x->position - test.origin).norm();
      CHECK(distance >= nearest - rounding);
      CHECK(distance <= farthest + rounding);
    }
  }
}

TEST_CASE("as the origin goes to infinity the critical points become those of the height") {
  // The sums of the offsets over all cases, for origins 1e2, 1e4 and 1e6 spans away.
  std::array<double, 3> offsets{};
  std::size_t compared = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const SkinSurface skin(support::ball_set(seed));
    const Vector v = random.direction();
    const auto heights = critical_points(skin, MorseFunction::height(v));
    if (!heights.degeneracies.empty()) continue;
    const double span = support::span_of(support::box_of(skin.points()));
    // A wall or a flat Hessian within 1e-2 spoils the first order; such points are left out.
    for (const CriticalPoint& p : heights.points) {
      const double rho = p.point.length_scale;
      const skin::Patch& patch = skin.complex().patch(p.point.cell);
      const double axial = patch.axis.dot(v);
      if (std::abs(1 - 2 * axial * axial) < 0.1) continue;
      if (side(skin.complex(), p.point.cell, p.point.position, 0.2 * rho) != Where::Inside)
        continue;
      ++compared;
      double distance_from_infinity = 1e2;
      for (double& sum : offsets) {
        const auto distances = from(skin, -distance_from_infinity * span * v);
        double offset = rho;
        for (const CriticalPoint& q : distances.points) {
          if (q.index != p.index) continue;
          offset = std::min(offset, (q.point.position - p.point.position).norm());
        }
        // x moves by rho / eta for each unit that the direction turns, eta >= 0.1.
        CHECK(offset <= 10 * rho * 2 / distance_from_infinity);
        sum += offset;
        distance_from_infinity *= 100;
      }
    }
  }
  CHECK(compared > 1000);
  CHECK(offsets[0] > 50 * offsets[1]);
  CHECK(offsets[1] > 50 * offsets[2]);
}

TEST_CASE("one ball has its nearest and farthest point on the line to the origin") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const Point centre = random.between(0, 10) * random.direction();
    const double radius = random.between(0.5, 3);
    const Vector out = random.direction();
    const Point origin = centre + std::pow(10, random.between(-3, 6)) * out;
    const auto critical =
        from(SkinSurface({ball(centre.x(), centre.y(), centre.z(), radius)}), origin);
    CHECK(critical.degeneracies.empty());
    REQUIRE(critical.points.size() == 2);
    for (const CriticalPoint& p : critical.points) {
      const double away = p.index == 0 ? 1 : -1;
      CHECK(p.index != 1);
      CHECK((p.point.position - centre - away * radius * out).norm() < 1e-9);
    }
  }
}

TEST_CASE("distances from a lone ball's centre are degenerate, a little off they are not") {
  const SkinSurface one({ball(1, 2, 3, 1.5)});
  CHECK(mentions(from(one, {1, 2, 3}), "patch of critical points"));
  CHECK(mentions(from(one, {1 + 1e-15, 2, 3}), "patch of critical points"));
  CHECK(from(one, {1 + 1e-9, 2, 3}).degeneracies.empty());
}

TEST_CASE("the centre of an atom is degenerate just when its sphere has a part in the skin") {
  std::size_t exposed = 0, buried = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const SkinSurface skin(support::ball_set(seed));
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
  }
  CHECK(exposed > 100);
  CHECK(buried > 30);
}

TEST_CASE(
    "a place of a circle, a sphere or a stretch of a line in a cell is found whenever there is "
    "one") {
  std::array<std::size_t, 2> found{}, absent{};
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const SkinSurface skin(support::ball_set(seed));
    const support::Box box = support::box_of(skin.points());
    for (int i = 0; i < 10; ++i) {
      const Point inside = box.sample(random);
      const CellId cell = skin.locate(inside, CellId{0U});
      const Point centre = inside + random.between(0, 4) * random.direction();
      const Circle circle{centre, random.direction(), random.between(0.1, 5)};
      const Vector e = circle.axis.unitOrthogonal(), f = circle.axis.cross(e);
      for (const bool is_circle : {true, false}) {
        bool expected = false;
        for (int k = 0; k < 1000 && !expected; ++k) {
          const double turn = 6.283185307179586 * random.uniform();
          const Vector out =
              is_circle ? Vector(std::cos(turn) * e + std::sin(turn) * f) : random.direction();
          expected = side(skin.complex(), cell, centre + circle.radius * out, 0) == Where::Inside;
        }
        const auto place = is_circle
                               ? point_in_cell(skin.complex(), cell, circle, 1e-9)
                               : point_in_cell(skin.complex(), cell, centre, circle.radius, 1e-9);
        if (expected) REQUIRE(place.has_value());
        ++(place ? found : absent)[static_cast<std::size_t>(is_circle)];
        if (!place) continue;
        CHECK(side(skin.complex(), cell, *place, 1e-9) != Where::Outside);
        CHECK((*place - centre).norm() == doctest::Approx(circle.radius));
        if (is_circle) CHECK(std::abs((*place - centre).dot(circle.axis)) < 1e-12);
      }
      const Stretch stretch{centre, circle.axis, random.between(0, 2), i % 2 ? 4 : INFINITY};
      bool expected = false;
      for (double t = stretch.from; t < std::min(stretch.to, 10.0); t += 0.01) {
        const Point x = centre + t * stretch.direction;
        expected = expected || side(skin.complex(), cell, x, 0) == Where::Inside;
      }
      const auto place = point_in_cell(skin.complex(), cell, stretch, 1e-9);
      if (expected) REQUIRE(place.has_value());
      if (!place) continue;
      CHECK(side(skin.complex(), cell, *place, 1e-8) != Where::Outside);
      CHECK((*place - centre).dot(stretch.direction) >= stretch.from - 1e-12);
      CHECK((*place - centre).dot(stretch.direction) <= stretch.to + 1e-12);
    }
  }
  for (const std::size_t count : found) CHECK(count > 100);
  for (const std::size_t count : absent) CHECK(count > 100);
}

TEST_CASE("distances from a point on a pair's axis have a circle of critical points, off it none") {
  const SkinSurface neck = pair(1);
  for (const double x : {0.0, 0.3, 0.9}) {
    CAPTURE(x);
    CHECK(mentions(from(neck, {x, 0, 0}), "circle of critical points"));
    for (const double off : {1e-9, 1e-3}) {
      const auto critical = from(neck, {x, off, 0.0});
      CHECK(critical.degeneracies.empty());
      CHECK(critical.euler_characteristic() == 2);
    }
  }
  // From far out on the axis the circle that solves the neck's equation is beyond its cell.
  const auto far = from(neck, {20, 0, 0});
  CHECK_FALSE(mentions(far, "circle"));
  CHECK(far.degeneracies.empty());
  CHECK(far.points.size() == 2);
}

TEST_CASE("the axis may run in any direction: rounding does not hide the circle") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const auto on_grid = [](const Vector& v) -> Vector {
      return v.unaryExpr(&geometry::on_exact_grid);
    };
    const Point middle = on_grid(random.between(0, 50) * random.direction());
    const Vector half = on_grid(random.direction());
    const SkinSurface skin({{middle - half, 2}, {middle + half, 2}});
    CHECK(mentions(from(skin, middle + 0.3 * half), "circle of critical points"));
  }
}

TEST_CASE("distances from the centre of curvature at the tip of a cap have a singular Hessian") {
  // The gap of two caps: half apart squared 3.0625, weights 2, so w/2 = -0.53125; the tips lie at
  // its root, the centres of curvature twice as far.
  const SkinSurface caps = pair(1.75);
  const double tip = std::sqrt(0.53125);
  CHECK(mentions(from(caps, {2 * tip, 0, 0}), "Hessian is singular"));
  for (const double x : {2 * tip - 1e-3, 2 * tip + 1e-3}) {
    const auto critical = from(caps, {x, 1e-4, 0});
    CHECK(critical.degeneracies.empty());
    CHECK(critical.euler_characteristic() == 4);
  }
}

TEST_CASE("where an origin crosses a neck's evolute two critical points meet, and it is said so") {
  const SkinSurface skin({ball(-1, 0, 0, 1), ball(1, 0, 0, 1)});
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
    CHECK(nearer.degeneracies.empty());
    CHECK(farther.degeneracies.empty());
    CHECK(nearer.euler_characteristic() == 2);
    CHECK(farther.euler_characteristic() == 2);
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

TEST_CASE("a height and a distance in one function have the critical points of a moved distance") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const SkinSurface skin(support::ball_set(seed));
    const Point origin = support::box_of(skin.points()).sample(random);
    const Vector direction = random.direction();
    constexpr double curvature = 0.25;
    const auto mixed = critical_points(skin, {direction, origin, curvature});
    const auto moved = from(skin, origin - 2 * direction);
    REQUIRE(mixed.points.size() == moved.points.size());
    for (std::size_t i = 0; i < mixed.points.size(); ++i) {
      CHECK(mixed.points[i].index == moved.points[i].index);
      CHECK(mixed.points[i].point.position == moved.points[i].point.position);
    }
  }
}

TEST_CASE("the same surface and origin give the same points, on a molecule as well") {
  const SkinSurface skin(support::molecule("9dna.pdb", skin::Model::Paper));
  const long chi = skin::dual_complex(skin).skin_euler_characteristic();
  support::Random random(1);
  for (int i = 0; i < 10; ++i) {
    const Point origin = support::box_of(skin.points()).sample(random);
    const auto critical = from(skin, origin), again = from(skin, origin);
    CHECK(critical.degeneracies.empty());
    CHECK(critical.euler_characteristic() == chi);
    REQUIRE(critical.points.size() == again.points.size());
    for (std::size_t k = 0; k < critical.points.size(); ++k) {
      CHECK(critical.points[k].point.position == again.points[k].point.position);
    }
  }
}
