#pragma once

#include "morse/integral_lines.h"
#include "morse/morse_smale_complex.h"
#include "tests/support/test.h"

namespace morskin::support {

/// A ball set with a height or, from odd seeds, a squared distance, and its critical points.
struct MorseCase {
  explicit MorseCase(unsigned seed)
      : random(seed + 1000000),
        skin(ball_set(seed)),
        f(function(seed)),
        critical(morse::critical_points(skin, f)) {}
  MorseCase(const WeightedPoints& points, const morse::MorseFunction& function)
      : random(0), skin(points), f(function), critical(morse::critical_points(skin, f)) {}

  bool is_degenerate() const { return !critical.degeneracies.empty(); }
  morse::IntegralLines lines(double step = morse::IntegralLines::usual_step) const {
    return morse::IntegralLines(skin, f, critical.points, step);
  }

  Random random;
  skin::SkinSurface skin;
  morse::MorseFunction f;
  morse::CriticalPoints critical;

 private:
  morse::MorseFunction function(unsigned seed) {
    if (seed % 2 == 0) return morse::MorseFunction::height(random.direction());
    const Box box = box_of(skin.points());
    return morse::MorseFunction::squared_distance(box.sample(random));
  }
};

/// Tries a law for those of many such cases that are not degenerate.
template <class Law>
void for_morse_cases(const Seeds& seeds, Law law) {
  for_seeds<MorseCase>(seeds, [&](MorseCase& test) {
    if (!test.is_degenerate()) law(test);
  });
}

inline morse::MorseSmaleComplex complex_of(const MorseCase& test) {
  return morse::morse_smale_complex(test.skin, test.f, test.critical);
}

/// A line with its nodes, as traced.
struct TracedLine {
  morse::CriticalId saddle;
  geometry::Vector tangent;
  morse::Direction direction;
  std::vector<geometry::Point> points;
  std::vector<geometry::CellId> cells;
  morse::Course course;

  morse::LineNodes nodes() const { return {saddle, tangent, direction, points, cells}; }
};

/// The lines of all saddles, four to each.
inline std::vector<TracedLine> traced_lines(const morse::IntegralLines& lines) {
  std::vector<TracedLine> all;
  for (std::size_t i = 0; i < lines.points().size(); ++i) {
    const morse::CriticalPoint& p = lines.points()[i];
    if (p.index != 1) continue;
    for (const double side : {1.0, -1.0}) {
      for (const morse::Direction direction : {morse::Direction::Down, morse::Direction::Up}) {
        TracedLine line{morse::CriticalId{i},
                        side * (direction == morse::Direction::Down ? p.descending : p.ascending),
                        direction,
                        {},
                        {},
                        {}};
        line.course = lines.trace(line.saddle, line.tangent, direction, line.points, line.cells);
        all.push_back(std::move(line));
      }
    }
  }
  return all;
}

}  // namespace morskin::support
