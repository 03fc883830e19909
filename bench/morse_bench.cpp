// Morse theory on the skin: critical points per second of a height and of a squared distance, the
// cost of their protecting spheres, integral lines and the Morse-Smale complex. Each row counts
// what speed could be traded for: the error of the lines, regions and lines that were lost. Run
// from the project's root.

#include <benchmark/benchmark.h>

#include "bench/bundled.h"
#include "certify/sizing.h"
#include "morse/integral_lines.h"
#include "morse/morse_smale_complex.h"
#include "morse/skin_spheres.h"

namespace {

using namespace morskin;
using benchmark::Counter;

void find(benchmark::State& state, const morse::MorseFunction& function) {
  const skin::SkinSurface surface(bundled_balls("1grm_model1.pdb"));
  std::size_t points = 0;
  for (auto _ : state) {
    const morse::CriticalPoints critical = morse::critical_points(surface, function);
    points = critical.points.size();
    if (!critical.degeneracies.empty()) state.SkipWithError(critical.degeneracies[0].c_str());
  }
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
  const skin::SkinSurface surface(bundled_balls("1grm_model1.pdb"));
  const morse::CriticalPoints critical = morse::critical_points(surface, {});
  const double share = certify::Sizing{}.tangent_disk_share();
  for (auto _ : state) {
    benchmark::DoNotOptimize(morse::protecting_spheres(surface, critical.points, share));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(critical.points.size()));
}

/// Tracing alone: the four lines of every saddle, with a step in hundredths of the length scale.
void integral_lines(benchmark::State& state) {
  const skin::SkinSurface skin(bundled_balls("1grm_model1.pdb"));
  const morse::MorseFunction f;
  const morse::CriticalPoints critical = morse::critical_points(skin, f);
  const morse::IntegralLines lines(skin, f, critical.points,
                                   static_cast<double>(state.range(0)) / 100);
  std::vector<geometry::Point> points;
  std::vector<geometry::CellId> cells;
  std::size_t traced = 0, nodes = 0, lost = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < critical.points.size(); ++i) {
      const morse::CriticalPoint& p = critical.points[i];
      if (p.index != 1) continue;
      for (const double side : {1.0, -1.0}) {
        points.clear();
        cells.clear();
        const morse::CriticalId id{i};
        lost +=
            !lines.trace(id, side * p.descending, morse::Direction::Down, points, cells).arrival;
        lost += !lines.trace(id, side * p.ascending, morse::Direction::Up, points, cells).arrival;
        traced += 2;
        nodes += points.size();
      }
    }
  }
  state.counters["lines/s"] = Counter(static_cast<double>(traced), Counter::kIsRate);
  state.counters["nodes/line"] = static_cast<double>(nodes) / static_cast<double>(traced);
  state.counters["accuracy"] = lines.accuracy();
  state.counters["lost"] = static_cast<double>(lost);
}

/// The whole complex: lines, their order, regions, components.
void complex(benchmark::State& state, const std::string& file, skin::Model model) {
  const skin::SkinSurface skin(bundled_balls(file, model));
  const morse::MorseFunction f;
  const morse::CriticalPoints critical = morse::critical_points(skin, f);
  morse::MorseSmaleComplex result;
  for (auto _ : state) result = morse::morse_smale_complex(skin, f, critical);
  state.counters["lines/s"] =
      Counter(static_cast<double>(result.arcs.size()), Counter::kIsIterationInvariantRate);
  state.counters["saddles"] = static_cast<double>(critical.count(1));
  state.counters["regions"] = static_cast<double>(result.regions.size());
  state.counters["merged"] = static_cast<double>(result.merged_lines);
  state.counters["degeneracies"] = static_cast<double>(result.degeneracies.size());
}

BENCHMARK(critical_points_of_height)->Unit(benchmark::kMicrosecond);
BENCHMARK(critical_points_of_distance)->Unit(benchmark::kMicrosecond);
BENCHMARK(protecting_spheres)->Unit(benchmark::kMicrosecond);
BENCHMARK(integral_lines)->Arg(30)->Arg(18)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complex, 1GRM_paper, std::string("1grm_model1.pdb"), skin::Model::Paper)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complex, 1GRM_vdw, std::string("1grm_model1.pdb"), skin::Model::Vdw)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complex, 1CRN_paper, std::string("1crn.pdb"), skin::Model::Paper)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
