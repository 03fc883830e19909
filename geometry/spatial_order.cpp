#include "geometry/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "geometry/parallel.h"

namespace morskin::geometry {
namespace {

constexpr int bits_per_axis = 20;
constexpr std::size_t first_round_size = 64;

/// A hash: the finaliser of splitmix64.
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// The cells of a cube around the points.
struct Grid {
  Point corner;
  double cells_per_length;

  explicit Grid(std::span<const WeightedPoint> points) {
    Point low = points[0].position;
    Point high = low;
    for (const WeightedPoint& p : points) {
      low = low.cwiseMin(p.position);
      high = high.cwiseMax(p.position);
    }
    const double extent = (high - low).maxCoeff();
    corner = low;
    cells_per_length = extent > 0 ? ((1 << bits_per_axis) - 1) / extent : 0;
  }
  std::uint64_t index(const Point& p) const {
    const Point cell = (p - corner) * cells_per_length;
    return hilbert_index(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y()),
                         static_cast<std::uint32_t>(cell.z()), bits_per_axis);
  }
};

/// One step down the curve: the octant of a cell, in the curve's order, and the curve's state in
/// that octant.
struct Step {
  std::uint8_t digit;
  std::uint8_t state;
};

/// The state of the curve in a cube is 3 * entry + axis: the corner where it enters and the axis
/// along which it leaves. A Gray code, rotated and reflected into the state, visits the octants.
constexpr std::array<std::array<Step, 8>, 24> make_steps() {
  const auto rotated_left = [](unsigned corner, unsigned shift) {
    return (corner << shift | corner >> (3 - shift)) & 7u;
  };
  const auto gray = [](unsigned i) { return i ^ i >> 1; };
  std::array<std::array<Step, 8>, 24> steps{};
  for (unsigned entry = 0; entry < 8; ++entry) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (unsigned digit = 0; digit < 8; ++digit) {
        const unsigned turn = (axis + 1) % 3;
        const unsigned octant = rotated_left(gray(digit), turn) ^ entry;
        const unsigned inner_entry = digit == 0 ? 0 : gray((digit - 1) & ~1u);
        const unsigned pair = digit % 7 == 0 ? 0u : (digit + 1) / 2;  // 1 2, 3 4, 5 6
        const unsigned inner_axis = pair == 0 ? 0u : pair == 2 ? 2u : 1u;
        steps[3 * entry + axis][octant] = {
            static_cast<std::uint8_t>(digit),
            static_cast<std::uint8_t>(3 * (entry ^ rotated_left(inner_entry, turn)) +
                                      (axis + inner_axis + 1) % 3)};
      }
    }
  }
  return steps;
}

constexpr auto steps = make_steps();

using Keyed = std::pair<std::uint64_t, AtomId>;

/// Sorts blocks and merges them two by two.
void sort(std::vector<Keyed>& values, unsigned threads) {
  constexpr std::size_t block = 32768;
  const auto at = [&](std::size_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>(std::min(i, values.size()));
  };
  for_each_block(
      threads, values.size(),
      [&](std::size_t begin, std::size_t end, std::size_t) { std::sort(at(begin), at(end)); },
      block);
  for (std::size_t half = block; half < values.size(); half *= 2) {
    for_each_task(threads, block_count(values.size(), 2 * half), [&](std::size_t k) {
      std::inplace_merge(at(2 * k * half), at((2 * k + 1) * half), at((2 * k + 2) * half));
    });
  }
}

}  // namespace

std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits) {
  std::uint64_t index = 0;
  std::size_t state = 0;
  for (int level = bits - 1; level >= 0; --level) {
    const std::size_t octant = (x >> level & 1) | (y >> level & 1) << 1 | (z >> level & 1) << 2;
    const Step step = steps[state][octant];
    index = index << 3 | step.digit;
    state = step.state;
  }
  return index;
}

SpatialOrder spatial_order(std::span<const WeightedPoint> points, unsigned threads) {
  if (points.empty()) return {};
  // A point skips each of the last rounds with probability 1/8.
  const int rounds_after_first =
      (static_cast<int>(std::bit_width(points.size() / first_round_size)) + 2) / 3;
  const Grid grid(points);
  std::vector<Keyed> keyed(points.size());
  for_each_block(threads, points.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const int skipped = std::countl_zero(scrambled(scrambled(1) + i)) / 3;
      const auto round = static_cast<std::uint64_t>(std::max(0, rounds_after_first - skipped));
      keyed[i] = {round << (3 * bits_per_axis) | grid.index(points[i].position), AtomId(i)};
    }
  });
  sort(keyed, threads);
  SpatialOrder order;
  order.ids.reserve(points.size());
  for (const auto& [key, id] : keyed) order.ids.push_back(id);
  for (int round = 0; round <= rounds_after_first; ++round) {
    const std::uint64_t next = (static_cast<std::uint64_t>(round) + 1) << (3 * bits_per_axis);
    const auto end = std::ranges::lower_bound(keyed, next, {}, &Keyed::first);
    order.ends.push_back(static_cast<std::size_t>(end - keyed.begin()));
  }
  return order;
}

}  // namespace morskin::geometry
