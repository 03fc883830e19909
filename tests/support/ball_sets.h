#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "geometry/point.h"
#include "geometry/predicates.h"

namespace morskin::support {

/// A seeded stream of doubles in [0, 1), the same with every standard library.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(n));
  }
  /// A whole number from one to another, both included.
  double whole(int low, int high) {
    return low + static_cast<double>(below(static_cast<std::size_t>(high - low) + 1));
  }
  /// The arrangement of a range by as many draws as it has elements, less one.
  template <class Range>
  void shuffle(Range& range) {
    for (std::size_t i = range.size(); i > 1; --i) std::swap(range[i - 1], range[below(i)]);
  }
  /// In a cube that the range spans along each axis.
  geometry::Point in_cube(double low, double high) {
    const double x = between(low, high), y = between(low, high);
    return {x, y, between(low, high)};
  }
  geometry::Vector direction() {
    for (;;) {
      const geometry::Vector v(between(-1, 1), between(-1, 1), between(-1, 1));
      if (v.squaredNorm() <= 1 && v.squaredNorm() > 0.01) return v.normalized();
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// A ball as the makers of sets think of it: its patch's radius instead of the weight.
struct Ball {
  geometry::Point centre;
  double radius;
};
using Balls = std::vector<Ball>;

inline std::vector<geometry::WeightedPoint> weighted(const Balls& balls) {
  std::vector<geometry::WeightedPoint> points;
  points.reserve(balls.size());
  for (const Ball& b : balls) {
    points.push_back({b.centre.unaryExpr(&geometry::on_exact_grid),
                      geometry::on_exact_grid(2 * b.radius * b.radius)});
  }
  return points;
}

/// 1 to 40 balls with patch radii from 0.5 to 3 Angstrom, in a box that makes them a loose chain, a
/// dense clump or a scatter; among them now and then a nested ball, a duplicate, and a ball that
/// nearly touches another (a gap or an overlap of 1e-1 to 1e-6 of its radius).
inline std::vector<geometry::WeightedPoint> ball_set(unsigned seed) {
  Random random(seed);
  const std::size_t n = 1 + random.below(40);
  const double box = random.between(1, 3) * std::cbrt(static_cast<double>(n)) * 1.7;
  Balls balls;
  while (balls.size() < n) {
    Ball ball{random.in_cube(0, box), random.between(0.5, 3)};
    const double kind = random.uniform();
    if (!balls.empty() && kind < 0.2) {
      const Ball& other = balls[random.below(balls.size())];
      if (kind < 0.05) {
        ball = other;
      } else if (kind < 0.1) {
        ball.radius = other.radius * random.between(0.2, 0.8);
        ball.centre =
            other.centre + (other.radius - ball.radius) * random.uniform() * random.direction();
      } else {
        // Patches meet where the spheres of radius sqrt(2) r touch.
        const double gap = (kind < 0.15 ? 1 : -1) * std::pow(10.0, -random.between(1, 6));
        ball.centre = other.centre + std::sqrt(2.0) * (other.radius + ball.radius) * (1 + gap) *
                                         random.direction();
      }
    }
    balls.push_back(ball);
  }
  return weighted(balls);
}

/// A ball of radius 1000 with many of radius 1 halfway to one of its poles, to each of which it has
/// an edge; they do not change the skin, a sphere.
inline std::vector<geometry::WeightedPoint> seeds_in_a_ball(std::size_t seeds) {
  Random random(1);
  Balls balls{{geometry::Point::Zero(), 1000}};
  while (balls.size() <= seeds) {
    const geometry::Vector off(random.between(-0.15, 0.15), 1, random.between(-0.15, 0.15));
    balls.push_back({500 * off.normalized(), 1});
  }
  return weighted(balls);
}

}  // namespace morskin::support
