#include "morse/cell_contact.h"
#include "morse/critical_points.h"
#include "skin/dual_complex.h"
#include "tests/support/critical_laws.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;
using skin::CellId;
using skin::SkinSurface;

namespace {

/// A random ball set, and an origin of the distance: among the balls, outside, far away, or within
/// 1 to 1e-8 Angstrom of the skin.
struct Case {
  explicit Case(unsigned seed) : random(seed), skin(ball_set(seed)), box(box_of(skin.points())) {
    const double span = span_of(box);
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

  Random random;
  SkinSurface skin;
  Box box;
  Point origin;
  CriticalPoints critical;
};

CriticalPoints from(const SkinSurface& skin, const Point& origin) {
  return critical_points(skin, MorseFunction::squared_distance(origin));
}

}  // namespace

TEST_CASE("every critical point of a distance lies on the skin, its normal towards the origin") {
  for_seeds<Case>(600, [&](const Case& test) {
    for (const CriticalPoint& p : test.critical.points) {
      check_on_skin(test.skin, p);
      const surface::SurfacePoint& x = p.point;
      // The part of x - p in the tangent plane, against the rounding of the places and, near a
      // small length scale, of the normal.
      const Vector towards = x.position - test.origin;
      const double size = x.position.norm() + test.origin.norm();
      CHECK((towards - towards.dot(x.normal) * x.normal).norm() <=
            1e-14 * size + 4 * rounding_at(test.skin, p) / x.length_scale * towards.norm());
      CHECK(p.value == towards.squaredNorm());
    }
  });
}

TEST_CASE("the index counts the descending directions of differences of the squared distance") {
  std::array<std::size_t, 3> met{};
  for_seeds<Case>(600, [&](const Case& test) {
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
      const Eigen::Vector2d values = hessian_values(p.point.normal, rise);
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
  });
  for (const std::size_t count : met) CHECK(count > 500);
}

TEST_CASE("minima - saddles + maxima of a distance is the skin's Euler characteristic") {
  std::size_t asked = 0, degenerate = 0;
  for_seeds<Case>(2000, [&](const Case& test) {
    ++asked;
    if (test.is_degenerate()) {
      ++degenerate;
      return;
    }
    CHECK(test.critical.euler_characteristic() ==
          skin::dual_complex(test.skin).skin_euler_characteristic());
  });
  CHECK(100 * degenerate < asked);
}

TEST_CASE("no point of the skin is nearer than the nearest minimum or farther than any maximum") {
  for_seeds<Case>(400, [&](Case& test) {
    if (test.is_degenerate()) return;
    double nearest = INFINITY, farthest = 0;
    for (const CriticalPoint& p : test.critical.points) {
      if (p.index == 0) nearest = std::min(nearest, std::sqrt(p.value));
      if (p.index == 2) farthest = std::max(farthest, std::sqrt(p.value));
    }
    const double rounding = 1e-10 * (span_of(test.box) + test.origin.norm());
    for (int i = 0; i < 100; ++i) {
      const auto x = test.skin.project(test.box.sample(test.random), CellId{0U});
      if (!x) continue;
      const double distance = (x->position - test.origin).norm();
      CHECK(distance >= nearest - rounding);
      CHECK(distance <= farthest + rounding);
    }
  });
}

TEST_CASE("as the origin goes to infinity the critical points become those of the height") {
  // The sums of the offsets over all cases, for origins 1e2, 1e4 and 1e6 spans away.
  std::array<double, 3> offsets{};
  std::size_t compared = 0;
  for_seeds<Random>(200, [&](unsigned seed, Random& random) {
    const SkinSurface skin(ball_set(seed));
    const Vector v = random.direction();
    const auto heights = critical_points(skin, MorseFunction::height(v));
    if (!heights.degeneracies.empty()) return;
    const double span = span_of(box_of(skin.points()));
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
  });
  CHECK(compared > 1000);
  CHECK(offsets[0] > 50 * offsets[1]);
  CHECK(offsets[1] > 50 * offsets[2]);
}

TEST_CASE("one ball has its nearest and farthest point on the line to the origin") {
  for_seeds<Random>(100, [&](Random& random) {
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
  });
}

TEST_CASE("a height and a distance in one function have the critical points of a moved distance") {
  for_seeds<Random>(50, [&](unsigned seed, Random& random) {
    const SkinSurface skin(ball_set(seed));
    const Point origin = box_of(skin.points()).sample(random);
    const Vector direction = random.direction();
    constexpr double curvature = 0.25;
    const auto mixed = critical_points(skin, {direction, origin, curvature});
    const auto moved = from(skin, origin - 2 * direction);
    REQUIRE(mixed.points.size() == moved.points.size());
    for (std::size_t i = 0; i < mixed.points.size(); ++i) {
      CHECK(mixed.points[i].index == moved.points[i].index);
      CHECK(mixed.points[i].point.position == moved.points[i].point.position);
    }
  });
}

TEST_CASE("the same surface and origin give the same points, on a molecule as well") {
  const SkinSurface skin(molecule("9dna.pdb", skin::Model::Paper));
  const long chi = skin::dual_complex(skin).skin_euler_characteristic();
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const Point origin = box_of(skin.points()).sample(random);
    const auto critical = from(skin, origin), again = from(skin, origin);
    CHECK(critical.degeneracies.empty());
    CHECK(critical.euler_characteristic() == chi);
    REQUIRE(critical.points.size() == again.points.size());
    for (std::size_t k = 0; k < critical.points.size(); ++k) {
      CHECK(critical.points[k].point.position == again.points[k].point.position);
    }
  }
}
