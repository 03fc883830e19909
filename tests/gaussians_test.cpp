// Sums of Gaussians: what a grid of voxels leaves out changes nothing, and the grid stays small.

#include "implicit/gaussians.h"

#include <sys/resource.h>

#include "geometry/error.h"
#include "implicit/implicit_surface.h"
#include "tests/support/ball_sets.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::Point;
using geometry::Vector;
using implicit::Ball;
using implicit::GaussianOptions;
using implicit::Gaussians;

namespace {

/// f and its gradient by a sum over all balls.
struct WholeSum {
  WholeSum(const std::vector<Ball>& balls, const GaussianOptions& options, const Point& x) {
    const auto power = [&](const Ball& ball) {
      const auto off = (x.cast<long double>() - ball.centre.cast<long double>()).eval();
      return off.squaredNorm() - static_cast<long double>(ball.radius) * ball.radius;
    };
    for (const Ball& ball : balls) least = std::min(least, power(ball));
    long double sum = 0;
    for (const Ball& ball : balls) {
      const long double weight = std::exp(-options.decay * (power(ball) - least));
      sum += weight;
      gradient += 2 * weight * (x.cast<long double>() - ball.centre.cast<long double>());
    }
    value = least - std::log(sum / options.level) / options.decay;
    gradient /= sum;
  }
  long double least = std::numeric_limits<long double>::infinity();
  long double value = 0;
  Eigen::Matrix<long double, 3, 1> gradient = Eigen::Matrix<long double, 3, 1>::Zero();
};

std::vector<Ball> balls_within(support::Random& random, double half, std::size_t count) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < count; ++i) {
    balls.push_back({half * random.in_cube(-1, 1), random.between(1, 2)});
  }
  return balls;
}

/// The most memory that the process has had, in MiB.
double peak_memory() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024;
}

}  // namespace

TEST_CASE("Gaussians are the sum over all balls, whichever are left out of a voxel") {
  std::size_t without_some = 0;
  support::for_seeds(25, [&](unsigned seed) {
    support::Random random(seed);
    const double half = std::pow(10, random.between(0, 3));
    const auto balls = balls_within(random, half, 1 + random.below(40));
    const GaussianOptions options{.decay = std::pow(10, random.between(-2, 1.5)),
                                  .level = std::pow(10, random.between(-2, 2))};
    const Gaussians f(balls, options);
    for (int k = 0; k < 100; ++k) {
      const Ball& near = balls[random.below(balls.size())];
      Point x = k % 3 == 0 ? Point(half * random.in_cube(-1.5, 1.5))
                           : Point(near.centre + 2 * near.radius * random.in_cube(-1, 1));
      const WholeSum whole(balls, options, x);
      const double size = static_cast<double>(x.squaredNorm()) + 3 * half * half;
      const auto [value, gradient] = f.at(x);
      CHECK(std::abs(value - whole.value) < 1e-13 * size + 1e-14 / options.decay);
      CHECK((gradient.cast<long double>() - whole.gradient).norm() < 1e-13L * (1 + size));
      const auto bounds = f.enclose(x);
      CHECK(bounds.value.low <= whole.value + 1e-18 * size);
      CHECK(bounds.value.high >= whole.value - 1e-18 * size);
      without_some += whole.least > 40 / options.decay;
    }
  });
  CHECK(without_some > 50);
}

TEST_CASE("the value of thousands of Gaussians is that of all of them together") {
  // 3,000 balls; were each asked for each of 110,592 voxels of two grids, 660 million questions.
  support::Random random(1);
  const auto balls = balls_within(random, 60, 3000);
  const Gaussians f(balls, {});
  for (int k = 0; k < 100; ++k) {
    const Point x = 60 * random.in_cube(-1, 1);
    CHECK(f.at(x).value ==
          doctest::Approx(static_cast<double>(WholeSum(balls, {}, x).value)).epsilon(1e-9));
  }
}

TEST_CASE("balls far apart take no more memory than near ones, and their sum is right") {
  support::Random random(1);
  for (const double apart : {1e2, 1e3, 1e4, 1e5, 1e6, 1e10}) {
    CAPTURE(apart);
    std::vector<Ball> balls = balls_within(random, 3, 8);
    for (Ball ball : balls_within(random, 3, 8)) {
      ball.centre += apart * Vector(1, 0.5, 0.2);
      balls.push_back(ball);
    }
    const double before = peak_memory();
    const Gaussians f(balls, {});
    CHECK(peak_memory() - before < 100);
    for (const Ball& ball : balls) {
      const Point x = ball.centre + 2 * random.direction();
      CHECK(f.at(x).value ==
            doctest::Approx(static_cast<double>(WholeSum(balls, {}, x).value)).epsilon(1e-6));
    }
  }
}

TEST_CASE("no ball, a decay and a level out of range are refused, each by its name") {
  const std::vector<Ball> ball{{Point::Zero(), 1}};
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH_AS(Gaussians({}, {}), doctest::Contains("needs an atom"),
                       geometry::RefusedInput);
  for (const double x : {-1.0, 0.0, 0.9e-3, 1.1e3, infinite, nan}) {
    CHECK_THROWS_WITH_AS(Gaussians(ball, {.decay = x}), doctest::Contains("decay"),
                         geometry::RefusedInput);
  }
  for (const double x : {-1.0, 0.0, 0.9e-6, 1.1e6, infinite, nan}) {
    CHECK_THROWS_WITH_AS(Gaussians(ball, {.level = x}), doctest::Contains("level"),
                         geometry::RefusedInput);
  }
  for (const double x : {1e-3, 1e3}) CHECK_NOTHROW(Gaussians(ball, {.decay = x}));
  for (const double x : {1e-6, 1e6}) CHECK_NOTHROW(Gaussians(ball, {.level = x}));
}

TEST_CASE("a level that the sum reaches nowhere is refused in these words") {
  std::vector<Ball> benzene;
  for (int k = 0; k < 6; ++k) {
    const Vector out(std::cos(k * M_PI / 3), std::sin(k * M_PI / 3), 0);
    benzene.push_back({1.39 * out, 1.7});
    benzene.push_back({2.48 * out, 1.2});
  }
  for (const double level : {11.0, 1e2, 1e6}) {
    CAPTURE(level);
    const auto f = std::make_shared<Gaussians>(benzene, GaussianOptions{.level = level});
    CHECK_THROWS_WITH_AS(implicit::prepare_surface(f, {f->extent(), false}, {}),
                         doctest::Contains("no zero"), geometry::RefusedInput);
  }
}
