#include "morse/integral_lines.h"

#include "tests/support/morse_lines.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;
using skin::CellId;

namespace {

double sign_of(const TracedLine& line) { return line.direction == Direction::Up ? 1 : -1; }

/// The part of f's gradient along the skin, in the line's direction, over the gradient's length.
Vector slope(const MorseCase& test, const surface::SurfacePoint& x, double sign) {
  const Vector g = sign * test.f.gradient(x.position).normalized();
  return g - g.dot(x.normal) * x.normal;
}

/// Places of lines on fixed shares of their rise.
std::vector<std::optional<IntegralLines::Passage>> places(const MorseCase& test, double step) {
  const IntegralLines lines = test.lines(step);
  std::vector<std::optional<IntegralLines::Passage>> all;
  for (const TracedLine& line : traced_lines(lines)) {
    const double start = test.critical.points[line.saddle.index()].value;
    for (const double share : {0.2, 0.5, 0.8}) {
      std::optional<IntegralLines::Passage> place;
      if (line.course.arrival) {
        const double end = test.critical.points[line.course.arrival->extremum.index()].value;
        place = lines.passage(line.nodes(), start + share * (end - start));
      }
      all.push_back(place);
    }
  }
  return all;
}

/// Distances over rho between the places found with a step and with one four times as fine as the
/// usual, sorted.
std::vector<double> errors(const MorseCase& test, double step) {
  const auto found = places(test, step), fine = places(test, IntegralLines::usual_step / 4);
  std::vector<double> all;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (!fine[i] || !found[i]) continue;
    all.push_back((found[i]->position - fine[i]->position).norm() / fine[i]->length_scale);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// f rises or falls strictly along every line, and every node lies on the skin and in its cell.
void check_lines(const MorseCase& test) {
  const skin::MixedComplex& complex = test.skin.complex();
  const IntegralLines lines = test.lines();
  for (const TracedLine& line : traced_lines(lines)) {
    bool is_monotone = true, is_on_skin = true, is_in_cell = true;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Point& x = line.points[i];
      // Where a take-off or a capture disc is tiny, the difference is below the rounding of f.
      const double rounding = 4e-16 * (std::abs(test.f(x)) + test.f.gradient(x).norm() * x.norm());
      is_monotone &=
          i == 0 || sign_of(line) * (test.f(x) - test.f(line.points[i - 1])) >= -rounding;
      const skin::Patch& patch = complex.patch(test.skin.locate(x, line.cells[i]));
      is_on_skin &= std::abs(patch.value(x)) <= test.skin.residual_bound(patch.length_scale(x));
      for (const skin::Wall& wall : complex.walls(line.cells[i])) {
        is_in_cell &= wall.normal.dot(x) - wall.offset <= 2 * complex.wall_tolerance();
      }
    }
    CHECK(is_monotone);
    CHECK(is_on_skin);
    CHECK(is_in_cell);
  }
}

}  // namespace

TEST_CASE("every line from a saddle ends at an extremum, in random sets of balls") {
  std::size_t count = 0;
  for_morse_cases(200, [&](const MorseCase& test) {
    const IntegralLines lines = test.lines();
    for (const TracedLine& line : traced_lines(lines)) {
      ++count;
      REQUIRE(line.course.arrival);
      const CriticalPoint& end = test.critical.points[line.course.arrival->extremum.index()];
      CHECK(end.index == (line.direction == Direction::Up ? 2 : 0));
      CHECK(line.points.front() == test.critical.points[line.saddle.index()].point.position);
      CHECK(line.points.back() == end.point.position);
    }
  });
  CHECK(count > 3000);
}

TEST_CASE("f rises or falls strictly along every line, and every node lies on the skin") {
  for_morse_cases(100, check_lines);
}

TEST_CASE(
    "lines stay on the skin where the direction runs along a patch's axis, but for rounding") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const WeightedPoints balls = ball_set(seed);
    const skin::SkinSurface skin(balls);
    Random random(seed);
    for (std::size_t cell = 0; cell < skin.complex().size(); cell += 101) {
      const Vector axis = skin.complex().patch(CellId{cell}).axis;
      if (axis.isZero()) continue;
      for (const double tilt : {0.0, 1e-16, 1e-13, 1e-8}) {
        CAPTURE(seed);
        CAPTURE(cell);
        CAPTURE(tilt);
        const MorseCase test(balls, MorseFunction::height(axis + tilt * random.direction()));
        if (!test.is_degenerate()) check_lines(test);
      }
    }
  }
}

TEST_CASE("the chord between two nodes is parallel to the gradient midway") {
  for_morse_cases(15, [&](const MorseCase& test) {
    constexpr double step = 0.02;
    const IntegralLines lines = test.lines(step);
    for (const TracedLine& line : traced_lines(lines)) {
      double worst = 0;
      // The first and the last piece are as long as the disc they cross, no step.
      for (std::size_t i = 2; i + 2 < line.points.size(); ++i) {
        const Vector chord = line.points[i] - line.points[i - 1];
        const auto middle =
            test.skin.project((line.points[i] + line.points[i - 1]) / 2, line.cells[i]);
        REQUIRE(middle);
        // Arcs in closed form have a node only every 0.3; chords near rounding have no direction.
        if (chord.norm() > 2 * step * middle->length_scale ||
            chord.norm() < 1e4 * test.skin.complex().wall_tolerance()) {
          continue;
        }
        worst = std::max(worst, chord.cross(slope(test, *middle, sign_of(line))).norm() /
                                    chord.norm() / slope(test, *middle, sign_of(line)).norm());
      }
      // Half way is off by the second order of a step's time, which is at most some tens of steps'
      // share where the flow is slow.
      CHECK(worst < 0.01);
    }
  });
}

TEST_CASE("halving the step divides the error by more than 2^7, across cell walls as well") {
  const MorseCase test(molecule("1crn.pdb", skin::Model::Paper), MorseFunction{});
  const std::vector<double> coarse = errors(test, 0.4), fine = errors(test, 0.2);
  for (const double share : {0.5, 0.9, 0.99}) {
    CAPTURE(share);
    const auto at = [&](const std::vector<double>& all) {
      return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
    };
    CHECK(at(coarse) > 128 * at(fine));
  }
}

TEST_CASE("with the usual step all but one place in 500 is as accurate as said") {
  for (const skin::Model model : {skin::Model::Paper, skin::Model::Vdw}) {
    for (const char* file : {"1crn.pdb", "1grm_model1.pdb", "9dna.pdb"}) {
      CAPTURE(file);
      const MorseCase test(molecule(file, model), MorseFunction{});
      const std::vector<double> all = errors(test, IntegralLines::usual_step);
      CHECK(all[all.size() - 1 - all.size() / 500] < IntegralLines::usual_accuracy);
    }
  }
}

TEST_CASE("on one ball every line is half a great circle to the pole, of heights and distances") {
  for_seeds<Random>(200, [&](unsigned seed, Random& random) {
    const Point centre = random.between(0, 10) * random.direction();
    const double radius = random.between(0.5, 3);
    const MorseFunction f =
        seed % 2 == 0
            ? MorseFunction::height(random.direction())
            : MorseFunction::squared_distance(centre + random.between(0.1, 9) * random.direction());
    const MorseCase test({ball(centre.x(), centre.y(), centre.z(), radius)}, f);
    const IntegralLines lines = test.lines();
    const Vector pole = f.gradient(centre).normalized();
    const Vector start = random.direction();
    const surface::SurfacePoint x = test.skin.at(centre + radius * start, CellId{0U});
    for (const Direction direction : {Direction::Down, Direction::Up}) {
      std::vector<Point> points;
      std::vector<CellId> cells;
      const Course course = lines.trace(x, direction, points, cells);
      REQUIRE(course.arrival);
      const double side = direction == Direction::Up ? 1 : -1;
      CHECK((points.back() - centre - side * radius * pole).norm() < 1e-13 * (radius + 10));
      const Vector normal = pole.cross(start).normalized();
      for (const Point& p : points) {
        CHECK(std::abs(normal.dot(p - centre)) < 1e-13 * (radius + 10));
        CHECK(std::abs((p - centre).norm() - radius) < 1e-13 * (radius + 10));
      }
    }
  });
}

TEST_CASE("the lines of a neck along its axis stay in the plane of axis and direction") {
  const MorseCase test({ball(-2, 0, 0, 1.8), ball(2, 0, 0, 1.5)},
                       MorseFunction::height(Vector(0.1, 1, 0.3)));
  const IntegralLines lines = test.lines();
  const Vector out = Vector::UnitX().cross(test.f.direction).normalized();
  std::size_t along = 0;
  for (const TracedLine& line : traced_lines(lines)) {
    if (std::abs(line.tangent.x()) < 0.5) continue;
    ++along;
    for (const Point& x : line.points) CHECK(std::abs(out.dot(x)) < 1e-13);
  }
  CHECK(along == 4);
}

TEST_CASE("no line that starts in a capture disc leaves it or ends elsewhere") {
  std::size_t discs = 0, starts = 0;
  for_morse_cases(600, [&](MorseCase& test) {
    const IntegralLines lines = test.lines(0.05);
    for (std::size_t i = 0; i < test.critical.points.size(); ++i) {
      const CaptureDisc& disc = lines.disc(CriticalId{i});
      if (disc.radius == 0) continue;
      ++discs;
      const CriticalPoint& p = test.critical.points[i];
      const double sign = p.index == 0 ? 1 : -1;
      CHECK(disc.radius <= lines.wall_distance(CriticalId{i}));
      for (int k = 0; k < 50; ++k) {
        const Vector away = disc.radius * test.random.between(0, 1.1) *
                            p.point.normal.cross(test.random.direction()).normalized();
        const auto x = test.skin.project(p.point.position + away, p.point.cell);
        if (!x || x->cell != p.point.cell) continue;
        const Vector u = x->position - test.skin.complex().patch(x->cell).centre;
        if (!disc.contains(u)) continue;
        ++starts;
        // A line from there stays in the disc up to its end.
        std::vector<Point> points;
        std::vector<CellId> cells;
        const Course course =
            lines.trace(*x, p.index == 0 ? Direction::Down : Direction::Up, points, cells);
        REQUIRE(course.arrival);
        CHECK(course.arrival->extremum == CriticalId{i});
        // The form is f's difference, and the gradient does not vanish.
        const double rise = sign * (test.f(x->position) - p.value);
        CHECK(std::abs(disc.height(u) - rise) <=
              1e-13 * (std::abs(p.value) + 10 * test.f.gradient(x->position).norm()));
        CHECK(slope(test, *x, 1).norm() > 0);
      }
      // On the rim, the whole circle at the disc's radius, f has passed the level.
      for (int k = 0; k < 50; ++k) {
        const Vector side = p.point.normal.cross(test.random.direction()).normalized();
        const auto x = test.skin.project(p.point.position + disc.radius * side, p.point.cell);
        if (!x || x->cell != p.point.cell) continue;
        const Vector d = x->position - p.point.position;
        const double level = d.dot(disc.form * d);
        // The projection has moved it along the normal a little; the bound goes with the square.
        CHECK(level >= disc.level * std::min(1.0, d.squaredNorm() / (disc.radius * disc.radius)) *
                           (1 - 1e-6));
      }
    }
  });
  CHECK(discs > 500);
  CHECK(starts > 10000);
}

TEST_CASE("lines find an extremum a millionth of its length scale from a cell wall") {
  // Two balls: as the direction tilts, the pole of one passes into the neck's cell.
  const WeightedPoints balls{ball(-1, 0, 0, 1), ball(1, 0, 0, 1)};
  const skin::SkinSurface pair(balls);
  const skin::Wall wall = pair.complex().walls(CellId{0U})[0];
  const double along = wall.offset - wall.normal.dot(Vector(-1, 0, 0));
  const Vector pole = along * wall.normal + std::sqrt(1 - along * along) * Vector(0, 0.8, 0.6);
  for (const double tilt : {1e-2, 1e-4, 1e-6, 1e-8}) {
    for (const double side : {-tilt, tilt}) {
      CAPTURE(side);
      const MorseCase test(balls, MorseFunction::height(pole + side * wall.normal));
      REQUIRE_FALSE(test.is_degenerate());
      const IntegralLines lines = test.lines();
      for (unsigned seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const auto x = test.skin.project(Point(-1, 0, 0) + random.direction(), CellId{0U});
        REQUIRE(x);
        std::vector<Point> points;
        std::vector<CellId> cells;
        for (const Direction direction : {Direction::Down, Direction::Up}) {
          CHECK(lines.trace(*x, direction, points, cells).arrival);
        }
      }
    }
  }
}

TEST_CASE("a line passes each level between its ends once, at its node if it has one there") {
  for_morse_cases(60, [&](const MorseCase& test) {
    const IntegralLines lines = test.lines();
    for (const TracedLine& line : traced_lines(lines)) {
      for (std::size_t i = 2; i + 2 < line.points.size(); i += 5) {
        const auto place = lines.passage(line.nodes(), test.f(line.points[i]));
        REQUIRE(place);
        const auto node = lines.passage_at(line.nodes(), i);
        CHECK((place->position - node.position).norm() <= lines.merge_distance(node.length_scale));
      }
      const double beyond = test.f(line.points.front()) - sign_of(line);
      CHECK_FALSE(lines.passage(line.nodes(), beyond));
    }
  });
}
