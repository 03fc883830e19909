// The cost of a tetrahedrization: growth alone, growth with the samples' Delaunay triangulation
// kept, and growth with one made anew at each metamorphosis (papers/5-dynamic.md). Run from the
// project's root.

#include <benchmark/benchmark.h>

#include <string>

#include "bench/baselines/dynamic_skin.h"
#include "geometry/regular_triangulation.h"
#include "geometry/stopwatch.h"
#include "morskin/mesh_skin.h"
#include "skin/model.h"
#include "skin/molecule_files.h"

namespace {

using namespace morskin;

enum class Tetrahedrization { None, Kept, Anew };

/// @return those of the triangulation of the mesh's vertices
std::size_t tetrahedra_of(const surface::Mesh& mesh) {
  std::vector<geometry::WeightedPoint> points;
  for (const surface::SurfacePoint& p : mesh.points) points.push_back({p.position, 0});
  return geometry::regular_triangulation(points).tetrahedra.size();
}

void growth(benchmark::State& state, const std::string& file, Tetrahedrization what) {
  const morskin::PreparedSkin skin = morskin::prepare_skin(skin::weighted_points(
      skin::read_molecule("bench/molecules/" + file), skin::Model::Paper, 1.4));
  baselines::KeptDelaunay kept;
  baselines::GrowthCounts counts;
  double seconds = 0;
  std::size_t tetrahedra = 0, triangles = 0;
  baselines::GrowthOptions options;
  if (what == Tetrahedrization::Kept) options.kept = &kept;
  if (what == Tetrahedrization::Anew) {
    // The snapshot of a metamorphosis' own time is of the mesh after it.
    for (const auto& m : baselines::find_metamorphoses(skin.surface, options.end)) {
      options.snapshot_times.push_back(m.time);
    }
    options.snapshot = [&](double, const surface::Mesh& mesh) {
      geometry::timed(seconds, [&] { tetrahedra += tetrahedra_of(mesh); });
    };
  }
  for (auto _ : state) {
    seconds = 0;
    tetrahedra = 0;
    const auto made = baselines::dynamic_mesher(options, &counts)(skin, {});
    triangles = made.mesh.surface.triangle_count();
  }
  if (counts.failed > 0) state.SkipWithError("a metamorphosis failed");
  if (what == Tetrahedrization::Kept) {
    seconds = kept.counts().seconds;
    tetrahedra = kept.counts().made;
  }
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["looks"] = static_cast<double>(counts.looks);
  state.counters["tetrahedra_made"] = static_cast<double>(tetrahedra);
  state.counters["tetrahedrization_s"] = seconds;
}

bool register_molecules() {
  for (const std::string file : {"two_balls.xyzr", "cube8.xyzr", "ring12.xyzr", "benzene.pdb",
                                 "caffeine.xyz", "5tmn_ligand.pdb"}) {
    const auto row = [&](const char* name, Tetrahedrization what) {
      benchmark::RegisterBenchmark((file + "/" + name).c_str(),
                                   [=](benchmark::State& state) { growth(state, file, what); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime()
          ->MeasureProcessCPUTime();
    };
    row("none", Tetrahedrization::None);
    row("kept", Tetrahedrization::Kept);
    row("anew", Tetrahedrization::Anew);
  }
  return true;
}

[[maybe_unused]] const bool is_registered = register_molecules();

}  // namespace

BENCHMARK_MAIN();
