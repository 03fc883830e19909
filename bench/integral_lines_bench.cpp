// Integral lines and the Morse-Smale complex of gramicidin and crambin. Each row counts what speed
// could be traded for: the error of the lines, regions and lines that were lost. Run from the
// project's root.

#include <benchmark/benchmark.h>

#include <string>

#include "morse/integral_lines.h"
#include "morse/morse_smale_complex.h"
#include "skin/model.h"
#include "skin/molecule_files.h"

namespace {

using namespace morskin;

skin::SkinSurface skin_of(const std::string& file, skin::Model model) {
  constexpr double probe = 1.4;  // Angstrom, as in section 2.1
  return skin::SkinSurface(
      skin::weighted_points(skin::read_molecule("bench/molecules/" + file), model, probe));
}

/// Tracing alone: the four lines of every saddle, with a step in hundredths of the length scale.
void integral_lines(benchmark::State& state) {
  const skin::SkinSurface skin = skin_of("1grm_model1.pdb", skin::Model::Paper);
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
  using benchmark::Counter;
  state.counters["lines/s"] = Counter(static_cast<double>(traced), Counter::kIsRate);
  state.counters["nodes/line"] = static_cast<double>(nodes) / static_cast<double>(traced);
  state.counters["accuracy"] = lines.accuracy();
  state.counters["lost"] = static_cast<double>(lost);
}

/// The whole complex: lines, their order, regions, components.
void complex(benchmark::State& state, const std::string& file, skin::Model model) {
  const skin::SkinSurface skin = skin_of(file, model);
  const morse::MorseFunction f;
  const morse::CriticalPoints critical = morse::critical_points(skin, f);
  morse::MorseSmaleComplex result;
  for (auto _ : state) result = morse::morse_smale_complex(skin, f, critical);
  using benchmark::Counter;
  state.counters["lines/s"] =
      Counter(static_cast<double>(result.arcs.size()), Counter::kIsIterationInvariantRate);
  state.counters["saddles"] = static_cast<double>(critical.count(1));
  state.counters["regions"] = static_cast<double>(result.regions.size());
  state.counters["merged"] = static_cast<double>(result.merged_lines);
  state.counters["degeneracies"] = static_cast<double>(result.degeneracies.size());
}

BENCHMARK(integral_lines)->Arg(30)->Arg(18)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complex, 1GRM_paper, std::string("1grm_model1.pdb"), skin::Model::Paper)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complex, 1GRM_vdw, std::string("1grm_model1.pdb"), skin::Model::Vdw)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complex, 1CRN_paper, std::string("1crn.pdb"), skin::Model::Paper)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
