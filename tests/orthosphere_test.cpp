#include "geometry/orthosphere.h"

#include <Eigen/LU>

#include "tests/support/test.h"

namespace morskin::geometry {
namespace {

using support::Random;

std::vector<WeightedPoint> random_balls(Random& random, std::size_t count) {
  std::vector<WeightedPoint> balls(count);
  for (WeightedPoint& ball : balls) {
    ball.position = random.in_cube(-3, 3);
    ball.weight = random.between(-6, 6);
  }
  return balls;
}

struct Orthosphere {
  Eigen::Matrix<long double, 3, 1> centre;
  long double weight;
};

/// By solving for the centre, in long doubles.
Orthosphere approximate_orthosphere(const std::vector<WeightedPoint>& simplex) {
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const auto arms = static_cast<Eigen::Index>(simplex.size()) - 1;
  Matrix edges(3, arms);
  Matrix heights(arms, 1);
  for (Eigen::Index i = 0; i < arms; ++i) {
    const WeightedPoint& p = simplex[static_cast<std::size_t>(i) + 1];
    edges.col(i) = p.position.cast<long double>() - simplex[0].position.cast<long double>();
    heights(i) = (edges.col(i).squaredNorm() + simplex[0].weight - p.weight) / 2;
  }
  Orthosphere result{simplex[0].position.cast<long double>(), simplex[0].weight};
  if (arms == 0) return result;
  const Matrix gram = edges.transpose() * edges;
  const Eigen::Matrix<long double, 3, 1> arm = edges * gram.fullPivLu().solve(heights);
  result.centre += arm;
  result.weight -= arm.squaredNorm();
  return result;
}

long double power(const Orthosphere& sphere, const WeightedPoint& v) {
  return (sphere.centre - v.position.cast<long double>()).squaredNorm() - v.weight;
}

}  // namespace

TEST_CASE("the sign of an orthocentre's weight agrees with long doubles on random simplices") {
  support::for_seeds<Random>(2000, [&](unsigned seed, Random& random) {
    const auto simplex = random_balls(random, 1 + seed % 4);
    const long double weight = approximate_orthosphere(simplex).weight;
    if (std::fabs(weight) < 1e-6L) return;
    CHECK(orthosphere_weight_sign(simplex) == sign_of(weight));
  });
}

TEST_CASE("the sign of a power over the orthocentre agrees with long doubles") {
  support::for_seeds<Random>(2000, [&](unsigned seed, Random& random) {
    const auto simplex = random_balls(random, 1 + seed % 3);
    const WeightedPoint v = random_balls(random, 1)[0];
    const Orthosphere sphere = approximate_orthosphere(simplex);
    const long double difference = power(sphere, v) + sphere.weight;
    if (std::fabs(difference) < 1e-6L) return;
    CHECK(orthosphere_power_sign(simplex, v) == sign_of(difference));
  });
}

TEST_CASE("two balls that touch have an edge of weight exactly zero") {
  // Radii 3 and 2 at distance 5: the orthocentre is the point of contact.
  const std::vector<WeightedPoint> edge{{{0, 0, 0}, 9}, {{5, 0, 0}, 4}};
  CHECK(orthosphere_weight_sign(edge) == Sign::Zero);
  // Along (1, 2, 2) / 3 and with a common factor that is no power of two.
  const std::vector<WeightedPoint> tilted{{{1, 1, 1}, 81}, {{6, 11, 11}, 36}};
  CHECK(orthosphere_weight_sign(tilted) == Sign::Zero);
  std::vector<WeightedPoint> overlapping = edge;
  overlapping[1].weight = std::nextafter(4, 5);
  CHECK(orthosphere_weight_sign(overlapping) == Sign::Positive);
  overlapping[1].weight = std::nextafter(4, 3);
  CHECK(orthosphere_weight_sign(overlapping) == Sign::Negative);
}

TEST_CASE("three and four balls through one point have weight exactly zero") {
  // Spheres through the origin whose centres do not put it outside their span.
  const std::vector<WeightedPoint> triangle{{{1, 2, 0}, 5}, {{-3, 1, 0}, 10}, {{2, -7, 0}, 53}};
  CHECK(orthosphere_weight_sign(triangle) == Sign::Zero);
  const std::vector<WeightedPoint> tetrahedron{
      {{1, 2, 3}, 14}, {{-3, 1, 5}, 35}, {{2, -7, 1}, 54}, {{4, 4, -9}, 113}};
  CHECK(orthosphere_weight_sign(tetrahedron) == Sign::Zero);
  auto grown = tetrahedron;
  for (WeightedPoint& ball : grown) ball.weight += 0x1p-40;
  CHECK(orthosphere_weight_sign(grown) == Sign::Positive);
}

TEST_CASE("the fourth corner of a rectangle is exactly on the circle of the other three") {
  const std::vector<WeightedPoint> triangle{{{0.1, 0.3, 0}, 0}, {{5, 0.3, 0}, 0}, {{5, 7, 0}, 0}};
  const auto power_at = [&](double x, double y) {
    return orthosphere_power_sign(triangle, {{x, y, 0}, 0});
  };
  CHECK(power_at(0.1, 7) == Sign::Zero);
  CHECK(power_at(std::nextafter(0.1, 1), 7) == Sign::Negative);
  CHECK(power_at(std::nextafter(0.1, 0), 7) == Sign::Positive);
  // And at a right angle to an edge: on the sphere over it.
  const std::vector<WeightedPoint> edge{triangle[0], triangle[2]};
  CHECK(orthosphere_power_sign(edge, triangle[1]) == Sign::Zero);
}

TEST_CASE("a single ball is attached to another that holds its centre more deeply") {
  const std::vector<WeightedPoint> small{{{1, 0, 0}, 1}};
  CHECK(orthosphere_power_sign(small, {{0, 0, 0}, 4}) == Sign::Negative);
  CHECK(orthosphere_power_sign(small, {{0, 0, 0}, 2}) == Sign::Zero);
  CHECK(orthosphere_power_sign(small, {{0, 0, 0}, 1}) == Sign::Positive);
}

TEST_CASE("the order of a simplex's points does not change its signs") {
  support::for_seeds<Random>(1000, [&](Random& random) {
    std::vector<WeightedPoint> simplex(4);
    for (WeightedPoint& ball : simplex) {
      for (double& x : ball.position) x = random.whole(-2, 2);
      ball.weight = random.whole(-2, 2);
    }
    if (orientation(simplex[0].position, simplex[1].position, simplex[2].position,
                    simplex[3].position) == Sign::Zero) {
      return;
    }
    const Sign weight = orthosphere_weight_sign(simplex);
    const Sign power = orthosphere_power_sign(std::span(simplex).first(3), simplex[3]);
    std::span triangle(simplex.data(), 3);
    random.shuffle(triangle);
    CHECK(orthosphere_power_sign(std::span(simplex).first(3), simplex[3]) == power);
    random.shuffle(simplex);
    CHECK(orthosphere_weight_sign(simplex) == weight);
  });
}

}  // namespace morskin::geometry
