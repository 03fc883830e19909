// Integral lines where the function is nearly degenerate: they creep along a curve of little slope,
// or run so near to a saddle that rounding decides on which side they pass.

#include "morse/integral_lines.h"
#include "morse/validate_complex.h"
#include "tests/support/morse_lines.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;

namespace {

/// Why the complex is not sound, or nothing.
std::string fault(const MorseCase& test) {
  const MorseSmaleComplex complex = complex_of(test);
  if (!complex.degeneracies.empty()) return complex.degeneracies.front();
  if (complex.regions.size() != 2 * test.critical.count(1)) return "two regions to a saddle";
  return validate(complex, std::vector<bool>(complex.points.size(), true)).value_or("");
}

std::size_t longest_line(const MorseCase& test) {
  const IntegralLines lines = test.lines();
  std::size_t longest = 0;
  for (const TracedLine& line : traced_lines(lines)) {
    longest = std::max(longest, line.points.size());
  }
  return longest;
}

WeightedPoints neck() { return {ball(-1.5, 0, 0, 1.5), ball(1.5, 0, 0, 1)}; }

/// The squared distance from a place so far beside the neck's axis: nearly a circle of minima.
MorseCase nearly_a_circle(double beside) {
  return {neck(), MorseFunction::squared_distance({0.3, beside, 0})};
}

/// A neck of two balls that overlap by this share, nearly a cone, and a height that makes this
/// angle with the normal along one of its lines.
MorseCase nearly_a_cone(double overlap, double angle) {
  const double a = std::acos(std::sqrt(0.5)) + angle;
  return {{ball(0, 0, 0, 1.5), ball(std::sqrt(2.0) * 2.5 * (1 - overlap), 0, 0, 1),
           ball(1, 3, 0.5, 1), ball(0.8, -3, 0.1, 1.1)},
          MorseFunction::height(
              {std::cos(a), std::sin(a) * std::cos(0.4), std::sin(a) * std::sin(0.4)})};
}

/// The case that a set of balls makes with a direction from the stream that made the balls. Two
/// balls of these sets that nearly touch lie along such a direction, so that it lies in the plane
/// of every triangle at their edge.
MorseCase along_own_stream(unsigned seed, int which) {
  Random random(seed);
  Vector direction = Vector::Zero();
  for (int i = 0; i < which; ++i) direction = random.direction();
  return {ball_set(seed), MorseFunction::height(direction)};
}

/// From a place that need not lie near the patch: the first times may miss it. Off it the formula
/// of the velocity has a pole.
Vector on_patch(const GradientFlow& flow, Vector u) {
  for (int i = 0; i < 8; ++i) u = flow.settled(u);
  REQUIRE(std::abs(flow.off(u)) < 1e-12 * u.squaredNorm());
  return u;
}

}  // namespace

TEST_CASE("the derivative of the flow is that of its differences") {
  for_seeds<Random>(1000, [&](Random& random) {
    skin::Patch patch{Vector::Zero(), Vector::Zero()};
    patch.sign = random.uniform() < 0.5 ? 1 : -1;
    if (random.uniform() < 0.8) patch.axis = random.direction();
    patch.half_weight = (patch.axis.norm() > 0 ? random.between(-2, 2) : 1) * patch.sign;
    const MorseFunction f = random.uniform() < 0.5
                                ? MorseFunction::height(random.direction())
                                : MorseFunction::squared_distance(5 * random.direction());
    const GradientFlow flow(patch, f, random.uniform() < 0.5 ? Direction::Up : Direction::Down);
    const Vector u = on_patch(flow, random.between(2, 3) * random.direction());
    const Eigen::Matrix3d derivative = flow.derivative(u);
    for (int i = 0; i < 3; ++i) {
      const Vector step = 1e-5 * Vector::Unit(i);
      const Vector difference = (flow(u + step) - flow(u - step)) / 2e-5;
      CHECK((difference - derivative.col(i)).norm() < 1e-7 * (1 + derivative.norm()));
    }
  });
}

TEST_CASE("an implicit step is of order 5: half the time divides its error by more than 2^5") {
  std::size_t better = 0, tried = 0;
  for_seeds<Random>(200, [&](Random& random) {
    const skin::Patch patch{Vector::Zero(), random.direction(), 1, 1};
    const GradientFlow flow(patch, MorseFunction::height(random.direction()), Direction::Up);
    const Vector u = on_patch(flow, 1.5 * random.direction());
    const auto error = [&](double time) {
      Vector exact = u;
      for (int i = 0; i < 16; ++i) exact = runge_kutta_step(flow, exact, flow(exact), time / 16);
      const auto end = radau_step(flow, u, flow(u), time);
      REQUIRE(end);
      return (*end - exact).norm();
    };
    const double whole = error(0.4), half = error(0.2);
    CHECK(whole < 1e-3);
    if (whole < 1e-9) return;  // too near to rounding
    ++tried;
    better += whole > 32 * half;
  });
  CHECK(tried > 100);
  CHECK(better > tried * 9 / 10);
}

TEST_CASE(
    "lines that creep round a circle of nearly minima find the minimum in some hundred steps") {
  for (const double beside : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    CAPTURE(beside);
    const MorseCase test = nearly_a_circle(beside);
    REQUIRE_FALSE(test.is_degenerate());
    CHECK(fault(test) == "");
    CHECK(longest_line(test) < 2000);
  }
}

TEST_CASE("lines that creep down a neck that is nearly a cone find their minimum") {
  std::size_t traced = 0;
  for (const double overlap : {1e-4, 1e-6}) {
    for (int k = 1; k < 16; k += 2) {
      for (const double sign : {1.0, -1.0}) {
        const double angle = sign * std::pow(10.0, -k);
        CAPTURE(overlap);
        CAPTURE(angle);
        const MorseCase test = nearly_a_cone(overlap, angle);
        if (test.is_degenerate()) continue;
        ++traced;
        CHECK(fault(test) == "");
        CHECK(longest_line(test) < 2000);
      }
    }
  }
  CHECK(traced > 20);
  CHECK(fault(along_own_stream(310, 4)) == "");
}

TEST_CASE("a creeping line lies where steps too short to be implicit find it") {
  const MorseCase test = nearly_a_circle(1e-3);
  const IntegralLines lines = test.lines();
  std::size_t compared = 0;
  for (const TracedLine& line : traced_lines(lines)) {
    for (std::size_t i = 1; i + 2 < line.points.size(); ++i) {
      const skin::Patch& patch = test.skin.complex().patch(line.cells[i]);
      const GradientFlow flow(patch, test.f, line.direction);
      Vector u = flow.to_local(line.points[i] - patch.centre);
      const Vector end = flow.to_local(line.points[i + 1] - patch.centre);
      if ((end - u).norm() < 20 * flow(u).norm()) continue;  // not an implicit step
      ++compared;
      const double sign = line.direction == Direction::Up ? 1 : -1, level = sign * flow.value(end);
      const double time = 0.05;
      Vector next = u;
      for (; sign * flow.value(next) < level; next = runge_kutta_step(flow, u, flow(u), time)) {
        u = next;
      }
      double low = 0, high = time;
      for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        next = runge_kutta_step(flow, u, flow(u), middle);
        (sign * flow.value(next) < level ? low : high) = middle;
      }
      CHECK((next - end).norm() < IntegralLines::usual_accuracy * end.norm());
    }
  }
  CHECK(compared > 20);
}

TEST_CASE("where a circle is level within rounding a line comes to rest, and that is reported") {
  std::size_t traced = 0;
  for (const double beside : {1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13}) {
    CAPTURE(beside);
    const MorseCase test = nearly_a_circle(beside);
    if (test.is_degenerate()) continue;
    ++traced;
    CHECK(contains(fault(test), "comes to rest where the function is flat within rounding"));
    CHECK(longest_line(test) < 2000);
  }
  CHECK(traced > 3);
}

TEST_CASE("the line round a waist passes the other saddle, or is reported where rounding decides") {
  for (int k = 1; k < 17; ++k) {
    const double tilt = std::pow(10.0, -k);
    CAPTURE(tilt);
    const MorseCase test(neck(), MorseFunction::height({tilt, 1, 0.25}));
    REQUIRE_FALSE(test.is_degenerate());
    const std::string why = fault(test);
    if (tilt > 1e-9) CHECK(why == "");
    if (tilt < 1e-12) CHECK(contains(why, "runs into the saddle"));
    CHECK((why.empty() || contains(why, "runs into the saddle")));
  }
}

TEST_CASE("a direction in the plane of a triangle with a waist is reported as a connection") {
  for (const unsigned seed : {58U, 211U, 281U, 513U, 547U, 754U, 796U, 929U, 1114U}) {
    CAPTURE(seed);
    const int which = seed < 281 ? 2 : 5;
    CHECK(contains(fault(along_own_stream(seed, which)), "runs into the saddle"));
  }
}
