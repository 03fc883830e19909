// The patches and the skin: mathematics.md section 11, T2, T4 and T5.

#include "skin/skin_surface.h"

#include <Eigen/Dense>
#include <span>

#include "geometry/error.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/skin_case.h"

using namespace morskin;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

double power(const WeightedPoint& p, const Point& x) {
  return (x - p.position).squaredNorm() - p.weight;
}

/// A bound from below on G(x), for any q: all weighted points looked at, no triangulation.
/// For any convex combination c of the balls, w_c <= |q - c|^2 - min_i f_i(q); minimise over all c.
double lower_bound(const std::vector<WeightedPoint>& points, const Point& x, const Point& q) {
  double least = std::numeric_limits<double>::infinity();
  for (const WeightedPoint& p : points) least = std::min(least, power(p, q));
  return least / 2 - (q - x).squaredNorm();
}

/// A bound from above on G(x): its value |x - c|^2 - w_c / 2 at one convex combination of balls.
double upper_bound(const std::vector<WeightedPoint>& points, std::span<const AtomId> atoms,
                   const Eigen::VectorXd& shares, const Point& x) {
  Point c = Point::Zero();
  double lifted = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const WeightedPoint& p = points[atoms[i].index()];
    const double share = shares[static_cast<Eigen::Index>(i)];
    // Seen from x, so that nothing cancels.
    c += share * (p.position - x);
    lifted += share * power(p, x);
  }
  return c.squaredNorm() / 2 + lifted / 2;
}

/// The convex combination of some balls whose centre is c, as nearly as there is one.
Eigen::VectorXd shares_of(const std::vector<WeightedPoint>& points, std::span<const AtomId> atoms,
                          const Point& c) {
  const auto n = static_cast<Eigen::Index>(atoms.size());
  Eigen::MatrixXd system(4, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point d = points[atoms[static_cast<std::size_t>(i)].index()].position - c;
    system.col(i) << d, 1;
  }
  Eigen::VectorXd shares = system.colPivHouseholderQr().solve(Eigen::Vector4d(0, 0, 0, 1));
  shares = shares.cwiseMax(0);
  return shares / shares.sum();
}

}  // namespace

TEST_CASE(
    "G is the minimum over all combinations of balls, bounded from both sides without cells") {
  for_points(20, [&](SkinCase& test, const Point& x) {
    const CellId cell = test.cell_of(x);
    const Patch& patch = test.skin.complex().patch(cell);
    const double g = patch.value(x);
    const Point c = x - patch.half_gradient(x), q = x + patch.half_gradient(x);
    const auto atoms = test.skin.atoms(cell);
    const auto shares = shares_of(test.skin.points(), atoms, c);
    // Tight at the pair (c, q) whose midpoint is x...
    CHECK(upper_bound(test.skin.points(), atoms, shares, x) <= g + test.value_rounding());
    CHECK(lower_bound(test.skin.points(), x, q) >= g - test.value_rounding());
    // ...and never crossed elsewhere.
    CHECK(lower_bound(test.skin.points(), x, test.box.sample(test.random)) <=
          g + test.value_rounding());
    std::vector<AtomId> any;
    Eigen::VectorXd some = Eigen::Vector4d::NullaryExpr([&] { return test.random.uniform(); });
    for (int k = 0; k < 4; ++k) any.emplace_back(test.random.below(test.skin.points().size()));
    CHECK(upper_bound(test.skin.points(), any, some / some.sum(), x) >= g - test.value_rounding());
  });
}

TEST_CASE(
    "where ties make cells without volume a walk from any cell finds G, at any place of them") {
  // Such a cell has no walls along its plane, and so points far away lie within its walls.
  for (unsigned round = 0; round < 100; ++round) {
    for (const Nasty kind :
         {Nasty::Lattice, Nasty::Coplanar, Nasty::SmallIntegers, Nasty::Cospherical}) {
      const auto seed = static_cast<unsigned>(round * nasty_kinds + static_cast<std::size_t>(kind));
      CAPTURE(seed);
      for (const auto keep : {MixedComplex::Keep::NearSkin, MixedComplex::Keep::All}) {
        const SkinSurface skin(nasty_set(seed), keep);
        const double span = span_of(box_of(skin.points()));
        Random random(seed);
        const auto some_centre = [&] {
          return skin.points()[random.below(skin.points().size())].position;
        };
        for (int i = 0; i < 200; ++i) {
          const Point a = some_centre(), b = some_centre();
          const double share = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5 : random.between(-0.5, 1.5);
          const Point x = a + share * (b - a);
          const CellId cell = skin.locate(x, CellId{random.below(skin.complex().size())});
          const auto [g, n] = skin.jet(x, cell);
          CHECK(lower_bound(skin.points(), x, x + n) >= g - 1e-10 * span * span);
        }
      }
    }
  }
}

TEST_CASE(
    "G leaves its tangent by no more than the square of the distance, whatever cells lie between") {
  for_points(20, [&](SkinCase& test, const Point& x) {
    // From a hair's breadth, where this is a difference quotient of the gradient, to the whole
    // box.
    const double h = test.span * std::pow(10.0, -test.random.between(0, 4));
    const Point y = x + h * test.random.direction();
    const double off = test.value(y) - test.value(x) - 2 * test.half_gradient(x).dot(y - x);
    CHECK(std::abs(off) <= (y - x).squaredNorm() + test.value_rounding());
  });
}

TEST_CASE("half the gradient changes no faster than the point moves") {
  for_points(20, [&](SkinCase& test, const Point& x) {
    const double h = test.span * std::pow(10.0, -test.random.between(0, 8));
    const Point y = x + h * test.random.direction();
    CHECK((test.half_gradient(x) - test.half_gradient(y)).norm() <=
          (x - y).norm() + test.length_rounding());
  });
}

TEST_CASE("a patch agrees with a central difference of itself, for all kinds of patch") {
  for_seeds<Random>(100, [&](Random& random) {
    const double axial = random.uniform() < 0.5 ? 0 : 1;
    Patch patch;
    patch.centre = random.between(0, 3) * random.direction();
    patch.axis = axial * random.direction();
    patch.sign = random.uniform() < 0.5 ? 1 : -1;
    patch.half_weight = random.between(-2, 2);
    const Point x = patch.centre + random.between(0.1, 3) * random.direction();
    constexpr double step = 1e-4,
                     difference_rounding = 1e-10;  // exact for a quadric but for rounding
    for (int k = 0; k < 3; ++k) {
      const Vector h = step * Vector::Unit(k);
      const double slope = (patch.value(x + h) - patch.value(x - h)) / (2 * step);
      CHECK(std::abs(slope - 2 * patch.half_gradient(x)[k]) < difference_rounding / step * 10);
    }
    CHECK(std::abs(patch.half_gradient(x).norm() - patch.length_scale(x)) < difference_rounding);
  });
}

TEST_CASE("value and gradient are the same on both sides of a wall") {
  std::size_t walls = 0;
  for_points(20, [&](SkinCase& test, const Point& inside) {
    const MixedComplex& complex = test.skin.complex();
    const CellId cell = test.cell_of(inside);
    for (const Wall& wall : complex.walls(cell)) {
      const Point x = inside + (wall.offset - wall.normal.dot(inside)) * wall.normal;
      if (outside(complex, cell, x) > complex.wall_tolerance()) continue;
      if (outside(complex, wall.beyond, x) > complex.wall_tolerance()) continue;
      ++walls;
      const Patch &here = complex.patch(cell), &there = complex.patch(wall.beyond);
      CHECK(std::abs(here.value(x) - there.value(x)) <= test.value_rounding());
      CHECK((here.half_gradient(x) - there.half_gradient(x)).norm() <= test.length_rounding());
    }
  });
  CHECK(walls > 1000);  // the law was put to the test
}

TEST_CASE(
    "the length scale is the reciprocal of the larger principal curvature, for all kinds of "
    "patch") {
  std::array<std::size_t, 4> met{};
  for_surface_points(20, [&](SkinCase& test, const SurfacePoint& p) {
    const Patch& patch = test.skin.complex().patch(p.cell);
    ++met[static_cast<std::size_t>(test.skin.complex().dimension(p.cell))];
    // The shape operator by differences of the normal along two tangents.
    const double h = 1e-4 * p.length_scale;
    const Vector e = p.normal.unitOrthogonal(), f = p.normal.cross(e);
    const auto turn = [&](const Vector& t) -> Vector {
      return (patch.normal(p.position + h * t) - patch.normal(p.position - h * t)) / (2 * h);
    };
    const Vector along_e = turn(e), along_f = turn(f);
    Eigen::Matrix2d shape;
    shape << along_e.dot(e), along_f.dot(e), along_e.dot(f), along_f.dot(f);
    shape = ((shape + shape.transpose()) / 2).eval();
    const double largest =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(shape).eigenvalues().cwiseAbs().maxCoeff();
    const double difference_error = 1e-7 + 1e4 * rounding * test.span / p.length_scale * 1e-4;
    CHECK(std::abs(largest * p.length_scale - 1) < difference_error);
  });
  for (const std::size_t count : met) CHECK(count > 0);
}

TEST_CASE("the sandwich balls of a point of the skin lie one in the body and one outside") {
  for_surface_points(10, [&](SkinCase& test, const SurfacePoint& p) {
    for (int k = 0; k < 10; ++k) {
      const Vector d = p.length_scale * std::cbrt(test.random.uniform()) * test.random.direction();
      CHECK(test.value(p.position - p.length_scale * p.normal + d) <= test.value_rounding());
      CHECK(test.value(p.position + p.length_scale * p.normal + d) >= -test.value_rounding());
    }
  });
}

TEST_CASE(
    "projection lands on the skin, is idempotent and moves a tangent step no farther than 7.2 "
    "allows") {
  for_surface_points(20, [&](SkinCase& test, const SurfacePoint& p) {
    const double rho = p.length_scale, r = test.random.between(0, 0.45) * rho;
    const Vector tangent = p.normal.cross(test.random.direction()).normalized();
    const Point x = p.position + r * tangent;
    const auto y = test.skin.project(x, p.cell);
    REQUIRE(y.has_value());
    CHECK(std::abs(test.value(y->position)) <=
          test.skin.residual_bound(y->length_scale) + 1e-6 * test.value_rounding());
    const double bound = (rho - r) - std::sqrt((rho - r) * (rho - r) - r * r);
    CHECK((y->position - x).norm() <= bound + test.length_rounding());
    // |G| / rho bounds how far a second projection can still find it from the skin.
    const auto again = test.skin.project(y->position, y->cell);
    REQUIRE(again.has_value());
    CHECK((again->position - y->position).norm() <=
          2 * test.skin.residual_bound(y->length_scale) / y->length_scale);
    const Patch& patch = test.skin.complex().patch(y->cell);
    CHECK(outside(test.skin.complex(), y->cell, y->position) <=
          test.skin.complex().wall_tolerance());
    CHECK(y->length_scale == patch.half_gradient(y->position).norm());
  });
}

TEST_CASE("a point of the skin on a wall projects to the same place from both cells") {
  std::size_t crossings = 0;
  for_surface_points(20, [&](SkinCase& test, const SurfacePoint& p) {
    const Vector tangent = p.normal.cross(test.random.direction()).normalized();
    const auto q = test.skin.project(p.position + 0.3 * p.length_scale * tangent, p.cell);
    if (!q || q->cell == p.cell) return;
    // Halve the chord until its ends are as near as numbers get, in different cells.
    SurfacePoint a = p, b = *q;
    for (int step = 0; step < 50; ++step) {
      const auto m = test.skin.project((a.position + b.position) / 2, a.cell);
      if (!m) break;
      (m->cell == a.cell ? a : b) = *m;
    }
    ++crossings;
    const auto from_a = test.skin.project(a.position, a.cell);
    const auto from_b = test.skin.project(a.position, b.cell);
    REQUIRE(from_a.has_value());
    REQUIRE(from_b.has_value());
    CHECK((from_a->position - from_b->position).norm() <=
          4 * test.skin.residual_bound(a.length_scale) / a.length_scale);
  });
  CHECK(crossings > 200);
}

TEST_CASE("doubling all lengths doubles the projection exactly") {
  for_seeds<SkinCase>(200, [&](SkinCase& test) {
    const SkinSurface twice(doubled(test.skin.points()));
    REQUIRE(twice.complex().size() == test.skin.complex().size());
    for (int i = 0; i < 20; ++i) {
      const Point x = test.box.sample(test.random);
      const auto p = test.skin.project(x, CellId{0U}), q = twice.project(2 * x, CellId{0U});
      REQUIRE(p.has_value() == q.has_value());
      if (!p) continue;
      CHECK(q->position == 2 * p->position);
      CHECK(q->length_scale == 2 * p->length_scale);
      CHECK(q->normal == p->normal);
      CHECK(q->cell == p->cell);
    }
  });
}

TEST_CASE("a skin without any positive weight is refused") {
  CHECK_THROWS_AS(SkinSurface(std::vector<WeightedPoint>{{{0, 0, 0}, 0.0}, {{1, 0, 0}, -1.0}}),
                  geometry::RefusedInput);
  CHECK_THROWS_AS(SkinSurface(std::vector<WeightedPoint>{}), geometry::RefusedInput);
}
