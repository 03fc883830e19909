// The molecules of the paper's Table 1 by each method of the library, and the main kernels. Each
// row counts what speed could be traded for: the smallest angle and the distance to [L] and [U].
// Run from the project's root.

#include <benchmark/benchmark.h>

#include "bench/bundled.h"
#include "geometry/files/mesh_files.h"
#include "geometry/stopwatch.h"
#include "morskin/pipeline.h"

namespace {

using namespace morskin;

/// Writes binary PLY and reads it back, in memory.
class AsFile : public morskin::Observer {
 public:
  Delivery deliver(geometry::IndexedMesh mesh, std::span<const geometry::CellId>) override {
    const std::string bytes = geometry::serialized(mesh, geometry::MeshFormat::PlyBinary);
    return {geometry::parse_mesh(bytes, "memory"), {}};
  }
};

std::string_view name_of(morskin::Method method) {
  return method == morskin::Method::Sweep ? "sweep" : "static";
}

/// The whole run: file in, mesh written in binary PLY form, read back and certified.
void whole_run(benchmark::State& state, const std::string& file, skin::Model model,
               morskin::Method method) {
  double floor = 0, seconds = 0;
  double morse = 0, smooth = 0;  // critical points, integral lines, simplification; smoothing
  certify::Certificate certificate;
  for (auto _ : state) {
    const geometry::Stopwatch stopwatch;
    const morskin::Run run(2);
    const morskin::PreparedSkin skin = morskin::prepare_skin(bundled_balls(file, model), run);
    AsFile as_file;
    const morskin::MeshResult result =
        morskin::make_mesh(skin, {.sizing = {}, .method = method}, as_file, run);
    certificate = result.certificate;
    seconds += stopwatch.seconds();
    morse += run.seconds("critical points") + run.seconds("integral lines");
    smooth += run.seconds("smooth");
    state.PauseTiming();
    floor += morskin::floor_seconds(skin.surface, result);
    state.ResumeTiming();
  }
  if (!certificate.certified) state.SkipWithError(certificate.reason.c_str());
  using benchmark::Counter;
  const auto triangles = static_cast<double>(certificate.triangles);
  state.counters["triangles"] = triangles;
  state.counters["triangles/s"] = Counter(triangles, Counter::kIsIterationInvariantRate);
  state.counters["min_angle_deg"] = certificate.min_angle_deg;
  state.counters["worst_L"] = certificate.worst_L;
  state.counters["worst_U"] = certificate.worst_U;
  state.counters["floor_ratio"] = seconds / floor;
  state.counters["morse_share"] = morse / seconds;
  state.counters["smooth_share"] = smooth / seconds;
}

/// Locating and projecting every vertex of gramicidin's mesh once, from its own cell.
void locate_and_project(benchmark::State& state) {
  const morskin::PreparedSkin skin =
      morskin::prepare_skin(bundled_balls("1grm_model1.pdb", skin::Model::Paper));
  const morskin::MeshResult result = morskin::make_mesh(skin);
  for (auto _ : state) benchmark::DoNotOptimize(morskin::floor_seconds(skin.surface, result));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(result.cells.size()));
}

BENCHMARK(locate_and_project)->Unit(benchmark::kMillisecond);

bool register_molecules() {
  for (const auto& [file, name] : {std::pair{"5tmn_ligand.pdb", "5TMN_inhibitor"},
                                   {"9dna.pdb", "9DNA_strand"},
                                   {"1grm_model1.pdb", "1GRM_gramicidin_A"}}) {
    for (const skin::Model model : {skin::Model::Paper, skin::Model::Sas, skin::Model::Vdw}) {
      for (const morskin::Method method : {morskin::Method::Sweep, morskin::Method::Static}) {
        const std::string row = std::string(name) + "/" + std::string(skin::name_of(model)) + "/" +
                                std::string(name_of(method));
        benchmark::RegisterBenchmark(
            row.c_str(),
            [=, file = file](benchmark::State& state) { whole_run(state, file, model, method); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime();
      }
    }
  }
  return true;
}

[[maybe_unused]] const bool is_registered = register_molecules();

}  // namespace

BENCHMARK_MAIN();
