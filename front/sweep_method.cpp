#include <algorithm>
#include <cmath>
#include <utility>

#include "front/method.h"
#include "front/two_fronts.h"
#include "geometry/stopwatch.h"

namespace morskin::front {

double sphere_share(const skin::SkinSurface& skin, const refine::Sizing& sizing) {
  double heaviest = 0;
  for (const auto& p : skin.points()) heaviest = std::max(heaviest, p.weight);
  const double rho = std::sqrt(heaviest / 2);
  return sizing.tangent_disk_share() * (sizing.scale(rho) / rho);
}

MethodResult sweep_method(const PreparedSkin& skin, const MeshOptions& options) {
  MethodResult result;
  const auto progress = [&](std::string_view stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  const refine::Sizing laid = options.sizing.laid();
  morse::Guide guide;
  geometry::timed(result.seconds.critical_points, [&] {
    guide =
        morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), options.function,
                          sphere_share(skin.surface, laid), options.threads, progress);
  });
  result.minima = guide.found[0];
  result.saddles = guide.found[1];
  result.maxima = guide.found[2];
  result.surviving_minima = guide.count(0);
  result.surviving_saddles = guide.count(1);
  result.surviving_maxima = guide.count(2);
  result.function = guide.function;

  geometry::timed(result.seconds.sweep, [&] {
    const auto guard = experimental_guard(options.guard, skin.surface, guide);
    SweepOptions sweeping{.sizing = laid};
    if (guard) sweeping.guard = guard.get();
    SweepExtras extras{.progress = [&](double share) { progress("sweep", share); }};
    if (options.sizing.is_coarser_than_laid()) extras.coarsening = {.sizing = options.sizing};
    const auto sweep_with_snapshots = [&] {
      Snapshots snapshots(guide, options.snapshot_values, options.snapshots, options.snapshot);
      return sweep_once(skin.surface, guide, sweeping, extras, {&snapshots});
    };
    SweepResult swept = options.fronts == 1 ? sweep_with_snapshots()
                                            : sweep_from_both_ends(skin.surface, guide, sweeping,
                                                                   options.threads, extras);
    result.mesh = std::move(swept.mesh);
    result.operations = swept.operations;
    result.open_edges = swept.open_edges;
  });
  if (result.open_edges > 0) return result;
  geometry::timed(result.seconds.refine, [&] {
    refine::Refinement refinement(skin.surface, options.sizing, result.mesh, options.threads);
    refinement.run([&](double share) { progress("refine", share); });
    result.refinement = refinement.counts();
  });
  return result;
}

}  // namespace morskin::front
