#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/orthosphere.h"
#include "geometry/predicates_internal.h"
#include "geometry/regular_triangulation.h"
#include "geometry/triangulator.h"

namespace morskin::geometry {
namespace {

using Points = std::vector<WeightedPoint>;

/// Unit density, so that every size has the same local geometry.
Points random_points(std::size_t count, double largest_weight) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const double side = std::cbrt(static_cast<double>(count));
  Points points(count);
  for (WeightedPoint& p : points) {
    for (int k = 0; k < 3; ++k) p.position[k] = side * unit(random);
    p.weight = largest_weight * unit(random);
  }
  return points;
}

Points lattice(int side, double step) {
  Points points;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      for (int k = 0; k < side; ++k) points.push_back({{step * i, step * j, step * k}, 0});
    }
  }
  return points;
}

void count_points(benchmark::State& state, std::size_t count) {
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

void insertion(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Points points = random_points(count, static_cast<double>(state.range(1)) / 10);
  for (auto _ : state) benchmark::DoNotOptimize(Triangulator(points).tetrahedra().data());
  state.SetComplexityN(state.range(0));
  count_points(state, count);
}
BENCHMARK(insertion)
    ->ArgNames({"points", "tenths_of_weight"})
    ->ArgsProduct({{10000, 100000, 1000000}, {0}})
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(insertion)->Name("weighted_insertion")->Args({100000, 5})->Unit(benchmark::kMillisecond);

void whole_complex(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Points points = random_points(count, 0);
  for (auto _ : state) benchmark::DoNotOptimize(regular_triangulation(points).vertices.data());
  state.SetComplexityN(state.range(0));
  count_points(state, count);
}
BENCHMARK(whole_complex)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

/// Every test is a near tie: with steps of 1 the integers decide, with steps of 0.1 only
/// expansions.
void lattice_insertion(benchmark::State& state) {
  const Points points = lattice(20, static_cast<double>(state.range(0)) / 10);
  for (auto _ : state) benchmark::DoNotOptimize(Triangulator(points).tetrahedra().data());
  count_points(state, points.size());
}
BENCHMARK(lattice_insertion)->ArgName("tenths")->Arg(10)->Arg(1)->Unit(benchmark::kMillisecond);

constexpr std::size_t pool_mask = 1023;

/// Five points of a pool, different ones each time.
template <class Predicate>
void run_on_fives(benchmark::State& state, const Points& pool, Predicate predicate) {
  std::size_t i = 0;
  for (auto _ : state) {
    ++i;
    benchmark::DoNotOptimize(predicate(
        pool[i & pool_mask], pool[(7 * i + 1) & pool_mask], pool[(13 * i + 2) & pool_mask],
        pool[(17 * i + 3) & pool_mask], pool[(19 * i + 5) & pool_mask]));
  }
}

/// Range 0: random doubles; 1: a lattice of integers, within the integer tier.
Points pool(const benchmark::State& state) {
  return state.range(0) == 0 ? random_points(pool_mask + 1, 0.5) : lattice(11, 1);
}

template <class Predicate>
void orthosphere_tier(benchmark::State& state, Predicate predicate) {
  run_on_fives(state, pool(state), predicate);
}
template <class Predicate>
void orientation_tier(benchmark::State& state, Predicate predicate) {
  run_on_fives(
      state, pool(state),
      [predicate](const auto& a, const auto& b, const auto& c, const auto& d, const auto&) {
        return predicate(a.position, b.position, c.position, d.position);
      });
}
BENCHMARK_CAPTURE(orientation_tier, filter, internal::filtered_orientation)->Arg(0)->Arg(1);
BENCHMARK_CAPTURE(orientation_tier, integer, internal::integer_orientation)->Arg(0)->Arg(1);
BENCHMARK_CAPTURE(orientation_tier, expansion, internal::expanded_orientation)->Arg(0)->Arg(1);
BENCHMARK_CAPTURE(orthosphere_tier, filter, internal::filtered_orthosphere)->Arg(0)->Arg(1);
BENCHMARK_CAPTURE(orthosphere_tier, integer, internal::integer_orthosphere)->Arg(0)->Arg(1);
BENCHMARK_CAPTURE(orthosphere_tier, refined, internal::refined_orthosphere)->Arg(0)->Arg(1);
BENCHMARK_CAPTURE(orthosphere_tier, expansion, internal::expanded_orthosphere)->Arg(0)->Arg(1);

void weight_sign(benchmark::State& state) {
  const Points balls = random_points(1024, 0.5);
  const auto size = static_cast<std::size_t>(state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    i = (i + 5) & pool_mask;
    const std::size_t first = std::min(i, balls.size() - size);
    benchmark::DoNotOptimize(orthosphere_weight_sign(std::span(balls).subspan(first, size)));
  }
}
BENCHMARK(weight_sign)->ArgName("points")->DenseRange(2, 4);

}  // namespace
}  // namespace morskin::geometry

BENCHMARK_MAIN();
