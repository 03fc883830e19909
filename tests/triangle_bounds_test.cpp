#include "certify/triangle_bounds.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>

#include "certify/distance_bounds.h"
#include "certify/tube.h"
#include "tests/support/ball_sets.h"
#include "tests/support/seeds.h"

using namespace morskin;
using certify::Offsets;
using geometry::Point;
using geometry::Vector;

namespace {

using Wide = Eigen::Matrix<long double, 3, 1>;

/// Of any shape down to needles of some last digits, of any scale, near the origin or far from it.
std::array<Point, 3> triangle(support::Random& random) {
  const double scale = std::pow(10.0, random.between(-8, 3));
  const Point a =
      random.below(2) == 0 ? Point(scale * random.direction()) : Point(1e5 * random.direction());
  const Vector along = scale * random.direction();
  const double thin = std::pow(10.0, random.between(-16, 0));
  const Point b = a + along;
  const Point c = a + random.between(-1, 2) * along + thin * scale * random.direction();
  return {a, b, c};
}

Point inside(support::Random& random, const Offsets& corners) {
  double s = random.uniform(), t = random.uniform();
  if (s + t > 1) s = 1 - s, t = 1 - t;
  return corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
}

}  // namespace

TEST_CASE("a triangle's bounds hold its circumradius and normal, of needles too") {
  std::size_t bounded = 0, tried = 0;
  support::for_seeds(20000, [&](unsigned seed) {
    support::Random random(seed);
    const auto [a, b, c] = triangle(random);
    const certify::TriangleBounds bounds = certify::triangle_bounds(a, b, c);
    const Wide e = b.cast<long double>() - a.cast<long double>();
    const Wide f = c.cast<long double>() - a.cast<long double>();
    const Wide cross = e.cross(f);
    ++tried;
    if (!std::isfinite(bounds.circumradius)) return;
    ++bounded;
    const long double R = e.norm() * f.norm() * (e - f).norm() / (2 * cross.norm());
    CHECK(bounds.circumradius >= R * (1 - 1e-12L));
    const long double shortest = std::min({e.norm(), f.norm(), (e - f).norm()});
    const double sine = certify::smallest_sine(bounds);
    CHECK(sine <= shortest / (2 * R));
    CHECK((bounds.normal.cast<long double>() - cross.normalized()).norm() <=
          bounds.normal_error + 1e-14L);
    const double thinness =
        static_cast<double>(cross.norm() / (e.norm() * f.norm()));  // sine of the angle at a
    if (thinness > 1e-3) CHECK(bounds.circumradius <= static_cast<double>(R) * (1 + 1e-9));
  });
  CHECK(bounded > tried / 2);
  CHECK(bounded < tried);  // some are so thin that nothing is known
  const Point p(1, 2, 3), q(4, 5, 6);
  CHECK(certify::triangle_bounds(p, p, q).circumradius == std::numeric_limits<double>::infinity());
  CHECK(certify::triangle_bounds(p, (p + q) / 2, q).circumradius ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("a path of the flow is bounded from above, to the last digits before it is not bounded") {
  support::for_seeds(20000, [&](unsigned seed) {
    support::Random random(seed);
    const double n = std::pow(10.0, random.between(-8, 8));
    const double share = 1 - std::pow(10.0, random.between(-17, 0));
    const double g = n * n * (random.below(2) == 0 ? share : 1 - share);
    const double path = certify::max_flow_path(n, g);
    const long double wide_n = n, square = wide_n * wide_n - g;
    if (square <= 0) {
      CHECK(path == std::numeric_limits<double>::infinity());
      return;
    }
    CHECK(path >= g / (wide_n + std::sqrt(square)));
  });
  CHECK(certify::max_flow_path(1, 0.75) == doctest::Approx(0.5));
  CHECK(certify::max_flow_path(1, 0) == 0);
  for (const double n : {0.0, -1.0, std::nan("")}) {
    CHECK(certify::max_flow_path(n, 0) == std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("no point of a triangle is nearer than its distance's bound, nor to a line") {
  support::for_seeds(2000, [&](unsigned seed) {
    support::Random random(seed);
    const auto corners = triangle(random);
    double size = 0;
    for (const Point& p : corners) size = std::max(size, (p - corners[0]).norm());
    const Point x = inside(random, corners) + size * random.between(0, 3) * random.direction();
    Offsets offsets;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      offsets[k] = corners[k] - x;
      longest = std::max(longest, offsets[k].norm());
    }
    const Vector direction = random.direction();
    const double distance = certify::distance_below(offsets);
    const double from_line = certify::distance_from_line_below(offsets, direction);
    double nearest = longest, nearest_to_line = longest;
    for (int i = 0; i < 300; ++i) {
      const Vector p = inside(random, offsets);
      nearest = std::min(nearest, p.norm());
      nearest_to_line = std::min(nearest_to_line, (p - p.dot(direction) * direction).norm());
    }
    CHECK(distance <= nearest + 1e-14 * longest);
    CHECK(from_line <= nearest_to_line + 1e-14 * longest);
    // To the last digit: offsets were rounded, and the direction may be no unit vector.
    const Wide along = direction.cast<long double>().normalized();
    for (const Point& p : corners) {
      const Wide to = p.cast<long double>() - x.cast<long double>();
      CHECK(distance <= to.norm());
      CHECK(from_line <= (to - to.dot(along) * along).norm());
    }
    // Not far below either, unless rounding hides the shape.
    CHECK(distance >= nearest - size);
  });
  const Offsets over{Vector(-1, -1, 2), Vector(2, -1, 2), Vector(-1, 2, 2)};
  CHECK(certify::distance_below(over) == doctest::Approx(2));
  CHECK(certify::distance_from_line_below(over, Vector(0, 0, 1)) == 0);
  CHECK(certify::distance_from_line_below(over, Vector(1, 0, 0)) == doctest::Approx(2));
}
