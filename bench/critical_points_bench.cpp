// Critical points per second of a height and of a squared distance, and the cost of their
// protecting spheres. Run from the project's root.

#include <benchmark/benchmark.h>

#include "certify/sizing.h"
#include "morse/critical_points.h"
#include "morse/skin_spheres.h"
#include "skin/model.h"
#include "skin/molecule_files.h"

namespace {

using namespace morskin;

skin::SkinSurface gramicidin() {
  constexpr double probe = 1.4;  // Angstrom, as in section 2.1
  return skin::SkinSurface(skin::weighted_points(
      skin::read_molecule("bench/molecules/1grm_model1.pdb"), skin::Model::Paper, probe));
}

void find(benchmark::State& state, const morse::MorseFunction& function) {
  const skin::SkinSurface surface = gramicidin();
  std::size_t points = 0;
  for (auto _ : state) {
    const morse::CriticalPoints critical = morse::critical_points(surface, function);
    points = critical.points.size();
    if (!critical.degeneracies.empty()) state.SkipWithError(critical.degeneracies[0].c_str());
  }
  using benchmark::Counter;
  state.counters["points"] = static_cast<double>(points);
  state.counters["cells"] = static_cast<double>(surface.complex().size());
  state.counters["points/s"] =
      Counter(static_cast<double>(points), Counter::kIsIterationInvariantRate);
}

void critical_points_of_height(benchmark::State& state) { find(state, {}); }

/// From an origin near the middle of the molecule, off every axis.
void critical_points_of_distance(benchmark::State& state) {
  find(state, morse::MorseFunction::squared_distance({1.23, 4.56, 7.89}));
}

void protecting_spheres(benchmark::State& state) {
  const skin::SkinSurface surface = gramicidin();
  const morse::CriticalPoints critical = morse::critical_points(surface, {});
  const double share = certify::Sizing{}.tangent_disk_share();
  for (auto _ : state) {
    benchmark::DoNotOptimize(morse::protecting_spheres(surface, critical.points, share));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(critical.points.size()));
}

BENCHMARK(critical_points_of_height)->Unit(benchmark::kMicrosecond);
BENCHMARK(critical_points_of_distance)->Unit(benchmark::kMicrosecond);
BENCHMARK(protecting_spheres)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
