// Marching cubes of gramicidin with as many triangles as the sweep makes, and the time of its
// parts. Run from the project's root.

#include <benchmark/benchmark.h>

#include "bench/baselines/marching_cubes.h"
#include "bench/baselines/narrow_band.h"
#include "morskin/pipeline.h"
#include "skin/model.h"
#include "skin/molecule_files.h"

namespace {

using namespace morskin;

const morskin::PreparedSkin& gramicidin() {
  static const morskin::PreparedSkin skin = morskin::prepare_skin(skin::weighted_points(
      skin::read_molecule("bench/molecules/1grm_model1.pdb"), skin::Model::Paper, 1.4));
  return skin;
}

void marching_cubes(benchmark::State& state) {
  const double step = baselines::step_like_sweep(gramicidin().surface);
  baselines::GridMesh made;
  for (auto _ : state) made = baselines::marching_cubes(gramicidin().surface, step);
  using benchmark::Counter;
  const auto triangles = static_cast<double>(made.mesh.triangles.size());
  state.counters["triangles"] = triangles;
  state.counters["triangles/s"] = Counter(triangles, Counter::kIsIterationInvariantRate);
}

/// Finding the cells near the skin, without evaluating their corners.
void narrow_band(benchmark::State& state) {
  const double step = baselines::step_like_sweep(gramicidin().surface);
  const baselines::Grid grid = baselines::grid_over(gramicidin().surface, step);
  std::int64_t cells = 0;
  for (auto _ : state) {
    baselines::for_each_cell_near_skin(gramicidin().surface, grid,
                                       [&](const auto&, geometry::CellId) { ++cells; });
  }
  state.SetItemsProcessed(cells);
}

void step_like_sweep(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(baselines::step_like_sweep(gramicidin().surface));
}

BENCHMARK(marching_cubes)->Unit(benchmark::kMillisecond);
BENCHMARK(narrow_band)->Unit(benchmark::kMillisecond);
BENCHMARK(step_like_sweep)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
