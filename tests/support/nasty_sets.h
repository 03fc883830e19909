#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/ball_sets.h"

namespace morskin::support {

/// Where one thing that meshers stumble over is the rule and not the exception.
enum class Nasty {
  Loose,           ///< ball_set: a chain, clump or scatter with now and then something nasty
  NearlyTouching,  ///< gaps and overlaps of 1e-3 to 1e-12 of the distance between two balls
  Duplicates,      ///< equal centres, with equal and unequal radii
  Nested,          ///< shells in shells, about one centre or nearly
  TinyBesideHuge,  ///< radii that differ up to ten-thousandfold
  Collinear,       ///< centres on a line
  Coplanar,        ///< centres on a plane's grid
  Lattice,         ///< cubic, body-centred or face-centred, with holes
  Cospherical,     ///< centres on a sphere, exactly
  SmallIntegers,   ///< a box of small whole numbers, radii in halves: every degeneracy at once
  FarClusters,     ///< small clusters up to 1e6 Angstrom apart
  ManyComponents,  ///< up to 500 balls that do not meet
};
constexpr std::array<std::string_view, 12> nasty_names = {
    "loose",        "nearly touching", "duplicates", "nested",      "tiny beside huge",
    "collinear",    "coplanar",        "lattice",    "cospherical", "small integers",
    "far clusters", "many components"};
constexpr std::size_t nasty_kinds = nasty_names.size();

/// Half of the time 0.5 to 3, else a multiple of 0.5 in that range.
inline double some_radius(Random& random) {
  if (random.uniform() < 0.5) return random.between(0.5, 3);
  return 0.5 * static_cast<double>(1 + random.below(6));
}

inline geometry::Point whole_point(Random& random, int most) {
  const auto coordinate = [&] {
    return static_cast<double>(random.below(2 * static_cast<std::size_t>(most) + 1)) - most;
  };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

/// Where a ball of radius r nearly touches another: beside it, or from within it.
inline Ball nearly_touching(Random& random, const Ball& other, double radius) {
  const double sign = random.uniform() < 0.5 ? -1 : 1;
  const double gap = sign * std::pow(10.0, -random.between(3, 12));
  const bool is_inside = radius != other.radius && random.uniform() < 0.25;
  // Patches meet where the spheres of radius sqrt(2) r touch.
  const double distance =
      std::sqrt(2.0) * (is_inside ? std::abs(other.radius - radius) : other.radius + radius);
  return {other.centre + distance * (1 + gap) * random.direction(), radius};
}

inline Balls nearly_touching_balls(std::size_t n, Random& random) {
  Balls balls{{whole_point(random, 5), some_radius(random)}};
  while (balls.size() < n) {
    balls.push_back(
        nearly_touching(random, balls[random.below(balls.size())], some_radius(random)));
  }
  return balls;
}

inline Balls duplicate_balls(std::size_t n, Random& random) {
  Balls balls;
  while (balls.size() < n) {
    balls.push_back({whole_point(random, 4), some_radius(random)});
    if (random.uniform() < 0.5) balls.push_back(balls[random.below(balls.size())]);
    if (random.uniform() < 0.5) {
      balls.push_back({balls[random.below(balls.size())].centre, some_radius(random)});
    }
  }
  return balls;
}

inline Balls nested_balls(std::size_t n, Random& random) {
  Balls balls;
  double radius = random.between(0.3, 1);
  geometry::Point centre = whole_point(random, 5);
  while (balls.size() < n) {
    balls.push_back({centre, radius});
    const double more = random.between(0.1, 1);
    // Sometimes the next sphere touches this one from outside, or nearly.
    if (random.uniform() < 0.5) centre += 1.5 * more * random.uniform() * random.direction();
    radius += more;
  }
  return balls;
}

inline Balls tiny_balls_beside_huge(std::size_t n, Random& random) {
  Balls balls;
  const double huge = random.between(10, 100);
  balls.push_back({whole_point(random, 3), huge});
  while (balls.size() < n) {
    const double radius = huge * std::pow(10.0, -random.between(1, 4));
    const Ball other = balls[random.below(balls.size())];
    const double reach = std::sqrt(2.0) * (other.radius + radius);
    balls.push_back(
        {other.centre + random.between(0.9, 1.05) * reach * random.direction(), radius});
  }
  return balls;
}

inline Balls collinear_balls(std::size_t n, Random& random) {
  Balls balls;
  const geometry::Point start = whole_point(random, 3);
  geometry::Vector step = whole_point(random, 2);
  if (step.isZero(0)) step = {1, 0, 0};
  while (balls.size() < n) {
    balls.push_back(
        {start + static_cast<double>(random.below(16)) * step / 2, some_radius(random)});
  }
  return balls;
}

inline Balls coplanar_balls(std::size_t n, Random& random) {
  Balls balls;
  const geometry::Vector u = whole_point(random, 2), v = whole_point(random, 2);
  while (balls.size() < 2 * n) {
    balls.push_back(
        {static_cast<double>(random.below(6)) * u + static_cast<double>(random.below(6)) * v,
         some_radius(random)});
  }
  return balls;
}

inline Balls lattice_balls(Random& random) {
  Balls balls;
  const std::size_t side = 2 + random.below(3), type = random.below(3);
  const double step = 0.5 * static_cast<double>(2 + random.below(8));
  const double radius = some_radius(random), hole = random.between(0, 0.5);
  const auto add = [&](double x, double y, double z) {
    if (random.uniform() >= hole) balls.push_back({step * geometry::Point(x, y, z), radius});
  };
  for (std::size_t i = 0; i < side * side * side; ++i) {
    const auto x = static_cast<double>(i % side), y = static_cast<double>(i / side % side),
               z = static_cast<double>(i / side / side);
    add(x, y, z);
    if (type == 1) add(x + 0.5, y + 0.5, z + 0.5);
    if (type == 2) {
      add(x + 0.5, y + 0.5, z);
      add(x, y + 0.5, z + 0.5);
      add(x + 0.5, y, z + 0.5);
    }
  }
  if (balls.empty()) balls.push_back({{0, 0, 0}, radius});
  return balls;
}

/// Of the 24 or 48 arrangements and signs of three whole numbers some are taken.
inline Balls cospherical_balls(Random& random) {
  Balls balls;
  const std::array<double, 3> numbers = {static_cast<double>(random.below(4)),
                                         static_cast<double>(1 + random.below(4)),
                                         static_cast<double>(random.below(5))};
  const double radius = some_radius(random), share = random.between(0.3, 1);
  const bool alike = random.uniform() < 0.7;
  for (std::size_t arrangement = 0; arrangement < 48; ++arrangement) {
    std::array<double, 3> p = numbers;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((arrangement >> axis & 1) != 0) p[axis] = -p[axis];
    }
    std::rotate(p.begin(), p.begin() + static_cast<long>(arrangement / 8 % 3), p.end());
    if (arrangement >= 24) std::swap(p[0], p[1]);
    if (random.uniform() < share) {
      balls.push_back({{p[0], p[1], p[2]}, alike ? radius : some_radius(random)});
    }
  }
  if (balls.empty()) balls.push_back({{0, 0, 0}, radius});
  return balls;
}

inline Balls small_integer_balls(std::size_t n, Random& random) {
  Balls balls;
  while (balls.size() < n) {
    balls.push_back({whole_point(random, 3), 0.5 * static_cast<double>(1 + random.below(4))});
  }
  return balls;
}

inline Balls far_clusters(std::size_t n, Random& random) {
  Balls balls;
  const double distance = std::pow(10.0, random.between(2, 6)) / std::sqrt(3.0);
  const std::size_t clusters = 2 + random.below(3);
  for (std::size_t c = 0; c < clusters; ++c) {
    const geometry::Point centre = random.in_cube(-distance, distance);
    for (std::size_t i = 0; i < n / 2 + 1; ++i) {
      balls.push_back({centre + random.between(0, 5) * random.direction(), some_radius(random)});
    }
  }
  return balls;
}

inline Balls many_components(Random& random) {
  Balls balls;
  const std::size_t side = random.uniform() < 0.1 ? 8 : 2 + random.below(3);
  const double step = random.between(3.1, 8), jitter = random.between(0, 1);
  for (std::size_t i = 0; i < std::min<std::size_t>(side * side * side, 500); ++i) {
    const geometry::Point at{step * static_cast<double>(i % side),
                             step * static_cast<double>(i / side % side),
                             step * static_cast<double>(i / side / side)};
    balls.push_back({at + jitter * random.direction(), random.between(0.2, 1)});
  }
  return balls;
}

inline Balls nasty_balls(Nasty kind, Random& random) {
  const std::size_t n = 2 + random.below(11);
  switch (kind) {
    case Nasty::Loose:
      break;  // has its own maker
    case Nasty::NearlyTouching:
      return nearly_touching_balls(n, random);
    case Nasty::Duplicates:
      return duplicate_balls(n, random);
    case Nasty::Nested:
      return nested_balls(n, random);
    case Nasty::TinyBesideHuge:
      return tiny_balls_beside_huge(n, random);
    case Nasty::Collinear:
      return collinear_balls(n, random);
    case Nasty::Coplanar:
      return coplanar_balls(n, random);
    case Nasty::Lattice:
      return lattice_balls(random);
    case Nasty::Cospherical:
      return cospherical_balls(random);
    case Nasty::SmallIntegers:
      return small_integer_balls(n, random);
    case Nasty::FarClusters:
      return far_clusters(n, random);
    case Nasty::ManyComponents:
      return many_components(random);
  }
  return {};
}

/// Turns all balls about the origin and moves them up to 1000 Angstrom: what was degenerate exactly
/// is so only nearly afterwards, by rounding, which is worse.
inline void turn_and_move(Random& random, Balls& balls) {
  const geometry::Vector x = random.direction();
  geometry::Vector z = x.cross(random.direction());
  while (z.norm() < 0.1) z = x.cross(random.direction());
  z.normalize();
  const geometry::Vector y = z.cross(x);
  const geometry::Vector shift = std::pow(10.0, random.between(-3, 3)) * random.direction();
  for (Ball& b : balls) {
    b.centre = shift + b.centre.x() * x + b.centre.y() * y + b.centre.z() * z;
  }
}

/// The kind that a seed stands for: they take turns.
inline Nasty nasty_kind(unsigned seed) { return static_cast<Nasty>(seed % nasty_kinds); }

/// The same balls for the same seed, with every standard library; every other set is turned.
inline std::vector<geometry::WeightedPoint> nasty_set(unsigned seed) {
  if (nasty_kind(seed) == Nasty::Loose) {
    return ball_set(seed / static_cast<unsigned>(nasty_kinds));
  }
  Random random(seed);
  Balls balls = nasty_balls(nasty_kind(seed), random);
  if (random.uniform() < 0.5) turn_and_move(random, balls);
  return weighted(balls);
}

}  // namespace morskin::support
