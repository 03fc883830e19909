#include "skin/orthocentre.h"

#include "geometry/orthosphere.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/rationals.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::support;
using geometry::Point;
using geometry::WeightedPoint;

namespace {

constexpr double promised = 0x1p-40;

double power(const WeightedPoint& p, const skin::Wide& x) {
  const skin::Wide centre = p.position.cast<long double>();
  return static_cast<double>((x - centre).squaredNorm() - p.weight);
}

/// Lattice points, turned so that what was flat or right-angled is so but for rounding: simplices
/// of all shapes, weights that cancel among them.
std::vector<WeightedPoint> some_simplex(unsigned seed, std::size_t size) {
  Random random(seed);
  const double whole = std::pow(10.0, -static_cast<double>(random.below(3)));
  Balls balls;
  while (balls.size() < size) {
    const Point at = whole * whole_point(random, 2);
    if (std::ranges::none_of(balls, [&](const Ball& b) { return b.centre == at; })) {
      balls.push_back({at, whole * 0.5 * static_cast<double>(1 + random.below(3))});
    }
  }
  turn_and_move(random, balls);
  return weighted(balls);
}

bool is_independent(const std::vector<WeightedPoint>& s) {
  if (s.size() == 3) return !geometry::are_collinear(s[0].position, s[1].position, s[2].position);
  return s.size() < 4 || geometry::orientation(s[0].position, s[1].position, s[2].position,
                                               s[3].position) != geometry::Sign::Zero;
}

/// Tries a law for such simplices of 2 to 4 points that are independent.
template <class Law>
void for_simplices(unsigned count, Law law) {
  for_seeds(count, [&](unsigned seed) {
    const auto simplex = some_simplex(seed, 2 + seed % 3);
    if (is_independent(simplex)) law(simplex);
  });
}

/// The orthocentre of a simplex in rational numbers: equal power to all, in the span.
rational::Vector exact_orthocentre(std::span<const WeightedPoint> simplex) {
  using namespace rational;
  const Vector first = exact(simplex[0].position);
  std::vector<Vector> edges;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    edges.push_back(minus(exact(simplex[i].position), first));
  }
  std::vector<std::vector<mpq_class>> rows;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    rows.emplace_back();
    for (const Vector& edge : edges) rows[i].push_back(2 * dot(edges[i], edge));
    rows[i].push_back(dot(edges[i], edges[i]) + mpq_class(simplex[0].weight) -
                      mpq_class(simplex[i + 1].weight));
  }
  const auto shares = solve(rows);
  REQUIRE(shares);
  Vector z = first;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) z[k] += (*shares)[i] * edges[i][k];
  }
  return z;
}

/// A long double, without a loss.
mpq_class rational_of(long double x) {
  const double high = static_cast<double>(x);
  return mpq_class(high) + mpq_class(static_cast<double>(x - high));
}

/// Points near each other with weights that have nothing to do with their distance: what cancels in
/// crowded atoms.
std::vector<WeightedPoint> crowded_simplex(unsigned seed, std::size_t size) {
  Random random(seed);
  const double edge = std::pow(10, random.between(-4, 0));
  const double weight = random.between(0.1, 20), spread = std::pow(10, random.between(-10, 0));
  const Point at = random.in_cube(-8, 8);
  std::vector<WeightedPoint> result;
  while (result.size() < size) {
    result.push_back({at + edge * random.in_cube(-1, 1), weight + spread * random.uniform()});
  }
  return result;
}

}  // namespace

TEST_CASE("the orthocentre does not depend on the order of the simplex, however flat or thin") {
  for_simplices(6000, [](std::vector<WeightedPoint> simplex) {
    const skin::Orthocentre z = skin::orthocentre(simplex);
    std::rotate(simplex.begin(), simplex.begin() + 1, simplex.end());
    std::swap(simplex[0], simplex[1]);
    const skin::Orthocentre again = skin::orthocentre(simplex);
    long double extent = 0;
    for (const WeightedPoint& p : simplex) {
      extent = std::max(extent, (z.position - p.position.cast<long double>()).norm());
    }
    CHECK((z.position - again.position).norm() <= 2 * promised * extent);
    CHECK(std::abs(z.weight - again.weight) <= 2 * promised * std::abs(z.weight));
  });
}

TEST_CASE("the orthocentre is right to 2^-40, as promised, where atoms crowd and weights cancel") {
  for_seeds(6000, [](unsigned seed) {
    const auto simplex = crowded_simplex(seed, 2 + seed % 3);
    if (!is_independent(simplex)) return;
    using namespace rational;
    const Vector z = exact_orthocentre(simplex), first = exact(simplex[0].position);
    const Vector far = minus(z, first), edge = minus(exact(simplex[1].position), first);
    const mpq_class weight = mpq_class(simplex[0].weight) - dot(far, far);
    const skin::Orthocentre found = skin::orthocentre(simplex);
    const Vector off{rational_of(found.position.x()) - z[0], rational_of(found.position.y()) - z[1],
                     rational_of(found.position.z()) - z[2]};
    const mpq_class bound = mpq_class(promised) * mpq_class(promised);
    CHECK(dot(off, off) <= bound * std::max(dot(far, far), dot(edge, edge)));
    CHECK(abs(rational_of(found.weight) - weight) <= mpq_class(promised) * abs(weight));
  });
}

TEST_CASE("the sign of an orthocentre's weight is the exact one") {
  std::size_t thin = 0;
  for_simplices(6000, [&](const std::vector<WeightedPoint>& simplex) {
    const skin::Orthocentre z = skin::orthocentre(simplex);
    thin += std::abs(z.weight) < 1e-12L * simplex[0].weight;
    CHECK(geometry::sign_of(z.weight) == geometry::orthosphere_weight_sign(simplex));
  });
  CHECK(thin > 10);  // the test is of some use
}

TEST_CASE("the orthocentre has equal power to all weighted points, as near as they can tell") {
  for_simplices(3000, [&](const std::vector<WeightedPoint>& simplex) {
    const skin::Orthocentre z = skin::orthocentre(simplex);
    const double distance =
        static_cast<double>((z.position - simplex[0].position.cast<long double>()).norm());
    for (const WeightedPoint& p : simplex) {
      const double scale = distance * distance + p.weight + p.position.squaredNorm();
      CHECK(std::abs(power(p, z.position) - power(simplex[0], z.position)) <= promised * scale);
    }
  });
}

TEST_CASE("the direction off a facet is a unit vector orthogonal to it, towards the other vertex") {
  for_simplices(6000, [&](const std::vector<WeightedPoint>& simplex) {
    std::vector<Point> points;
    for (const WeightedPoint& p : simplex) points.push_back(p.position);
    const geometry::Vector d = skin::direction_off_facet(points);
    CHECK(std::abs(d.norm() - 1) < 1e-14);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const geometry::Vector along = points[i] - points[0];
      CHECK(std::abs(d.dot(along)) <= promised * along.norm());
    }
    if (points.size() < 4) return;
    const auto side = geometry::orientation(points[0], points[1], points[2], points[3]);
    const Point far = points[0] + d;
    CHECK(geometry::orientation(points[0], points[1], points[2], far) == side);
  });
}

TEST_CASE("the rough weight of a tetrahedron is its orthocentre's to 2^-20 of its first point's") {
  constexpr double promised_share = 0x1p-20;
  std::size_t tested = 0;
  for_seeds(6000, [&](unsigned seed) {
    const std::vector<WeightedPoint> simplex = some_simplex(seed, 4);
    if (!is_independent(simplex)) return;
    ++tested;
    const double exact = static_cast<double>(skin::orthocentre(simplex).weight);
    const double rough = skin::rough_weight({simplex[0], simplex[1], simplex[2], simplex[3]});
    CHECK(std::abs(rough - exact) <= promised_share * std::abs(simplex[0].weight));
  });
  CHECK(tested > 3000);  // the law was put to the test
}

TEST_CASE(
    "a point in a free ball about an orthocentre is in it, and there is one unless it is tiny") {
  using namespace rational;
  std::size_t found = 0, none = 0;
  for_seeds(3000, [&](unsigned seed) {
    const std::vector<WeightedPoint> corners = some_simplex(seed, 4);
    if (!is_independent(corners)) return;
    const skin::Orthocentre z = skin::orthocentre(corners);
    if (!(z.position.norm() < 1e4)) return;  // lighter weights would round, and move it
    for (const double radius : {1.0, 1e-3, 1e-8, 1e-15, 1e-17, 0.0}) {
      CAPTURE(radius);
      std::array<WeightedPoint, 4> simplex;
      std::ranges::copy(corners, simplex.begin());
      for (WeightedPoint& p : simplex) p.weight -= static_cast<double>(z.weight) + 2 * radius;
      const Vector centre = exact_orthocentre(simplex);
      const Vector arm = minus(centre, exact(simplex[0].position));
      const mpq_class clearance = (dot(arm, arm) - mpq_class(simplex[0].weight)) / 2;  // squared
      const mpq_class size = abs(centre[0]) + abs(centre[1]) + abs(centre[2]);
      const mpq_class rounding = 0x1p-53 * size;
      const auto point = skin::point_in_free_ball(simplex);
      ++(point ? found : none);
      if (!point) CHECK(clearance <= rounding * rounding);
      if (!point) continue;
      const Vector off = minus(exact(*point), centre);
      CHECK(dot(off, off) < clearance);
      CHECK(dot(off, off) <= 2 * rounding * rounding);
    }
  });
  CHECK(found > 3000);
  CHECK(none > 1000);
}
