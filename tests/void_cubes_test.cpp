// Voids against the cubes that measure them: two chambers that nearly touch, or are joined by a
// neck far thinner than any cube, and voids as small as what coordinates leave open.

#include "skin/void_volume.h"
#include "tests/support/meshes.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::Point;
using geometry::Vector;
using geometry::WeightedPoint;
using skin::VolumeBounds;

namespace {

/// Two equal chambers along an axis, with three balls about what lies between them.
/// @param half_weight  w/2 of the neck's orthocentre, the origin: it is closed where that is above
/// 0
std::vector<WeightedPoint> two_chambers(const Vector& axis, const Vector& first,
                                        const Vector& second, double half_weight) {
  constexpr double to_chamber = 0.125;
  std::vector<WeightedPoint> points;
  for (const Vector& around : {Vector(first), Vector(-first + second), Vector(-first - second)}) {
    points.push_back({around, around.squaredNorm() + 2 * half_weight});
  }
  // The power of the chambers' deepest points by the three, at which it is as much by the fourth.
  const double power = to_chamber * to_chamber * axis.squaredNorm() - 2 * half_weight;
  for (const double side : {-1.0, 1.0}) {
    const double beyond = 1 - to_chamber;
    points.push_back({side * axis, beyond * beyond * axis.squaredNorm() - power});
  }
  return points;
}

}  // namespace

TEST_CASE("chambers with a neck thinner than any cube are one void, that touch nearly are two") {
  const std::array<std::array<Vector, 3>, 3> ways{{
      {Vector(1, 1, 0), Vector(0, 0, 1.5), Vector(1, -1, 0)},
      {Vector(1, 1, 1), Vector(1.25, -1.25, 0), Vector(0.75, 0.75, -1.5)},
      {Vector(1, 2, 2), Vector(2, 1, -2), Vector(2, -2, 1)},
  }};
  for (const auto& way : ways) {
    const auto &axis = way[0], &first = way[1], &second = way[2];
    for (const int exponent : {24, 44}) {
      CAPTURE(axis);
      CAPTURE(exponent);
      const double thin = std::ldexp(1, -exponent);
      const auto open = support::prepared(two_chambers(axis, first, second, -thin));
      const auto closed = support::prepared(two_chambers(axis, first, second, thin));
      REQUIRE(open);
      REQUIRE(closed);
      REQUIRE(open->topology.voids.size() == 1);
      REQUIRE(closed->topology.voids.size() == 2);
      const auto volume = [](const auto& of, std::uint32_t cavity) {
        return skin::void_volume(of->surface, of->topology, cavity, 0.25);
      };
      const VolumeBounds whole = volume(open, 0);
      const VolumeBounds half = volume(closed, 0), other = volume(closed, 1);
      // A neck's half weight moves the skin by no more than its root.
      const double moved = 10 * std::sqrt(thin) * whole.high;
      CHECK(whole.low <= half.high + other.high + moved);
      CHECK(whole.high >= half.low + other.low - moved);
      CHECK(std::max(half.high, other.high) < whole.low - moved);
    }
  }
}

TEST_CASE("a void's volume lies within its bounds where coordinates are coarse beside it") {
  const std::vector<std::pair<double, double>> sizes_and_places{
      {1, 0}, {1, 0x1p14}, {1, 0x1p19}, {0x1p-10, 0}, {0x1p-10, 16}, {0x1p-10, 0x1p14}};
  for (const auto& [size, far] : sizes_and_places) {
    CAPTURE(size);
    CAPTURE(far);
    // Nearly the square of the corners' distance from the middle.
    const double weight = 3 * size * size * (1 - 0x1p-52);
    std::vector<WeightedPoint> points;
    for (const Vector& corner :
         {Vector(1, 1, 1), Vector(1, -1, -1), Vector(-1, 1, -1), Vector(-1, -1, 1)}) {
      points.push_back({Point::Constant(far) + size * corner, weight});
    }
    const auto skin = support::prepared(points);
    REQUIRE(skin);
    REQUIRE(skin->topology.voids.size() == 1);
    const double radius = std::sqrt((3 * size * size - weight) / 2);
    const double volume = 4 * M_PI / 3 * std::pow(radius, 3);
    const VolumeBounds found = skin::void_volume(skin->surface, skin->topology, 0);
    CHECK(found.low <= volume);
    CHECK(found.high >= volume);
    if (far == 0) CHECK(found.high < 1.02 * found.low);
  }
}
