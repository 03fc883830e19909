#include <algorithm>
#include <cmath>
#include <utility>

#include "front/two_fronts.h"
#include "geometry/stopwatch.h"
#include "morse/make_guide.h"
#include "morse/skin_spheres.h"
#include "morskin/method.h"

namespace morskin {

namespace {

/// The guard asked for, unless it is the default.
std::optional<front::NarrowGuard> experimental_guard(front::Guard guard,
                                                     const skin::SkinSurface& skin,
                                                     const morse::Guide& guide) {
  constexpr double enlargement = 3;
  if (guard == front::Guard::Everywhere) return std::nullopt;
  std::vector<double> radii;
  for (std::size_t c = 0; c < guide.points.size(); ++c) {
    radii.push_back(enlargement * guide.spheres.radius(morse::CriticalId{c}));
  }
  return front::NarrowGuard(morse::protecting_spheres(skin, guide.points, std::move(radii)),
                            guard == front::Guard::Adjacent);
}

}  // namespace

double sphere_share(const skin::SkinSurface& skin, const certify::Sizing& sizing) {
  const double rho = skin.max_length_scale();
  return sizing.tangent_disk_share() * (sizing.scale(rho) / rho);
}

MethodResult sweep_method(const PreparedSkin& skin, const MeshOptions& options) {
  MethodResult result;
  const auto progress = [&](std::string_view stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  const certify::Sizing laid = options.sizing.laid();
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
    front::SweepOptions sweeping{.sizing = laid};
    if (guard) sweeping.guard = &*guard;
    front::SweepExtras extras{.progress = [&](double share) { progress("sweep", share); }};
    if (options.sizing.is_coarser_than_laid()) extras.coarsening = {.sizing = options.sizing};
    const auto sweep_with_snapshots = [&] {
      front::Snapshots snapshots(guide, options.snapshot_values, options.snapshots,
                                 options.snapshot);
      return front::sweep_once(skin.surface, guide, sweeping, extras, {&snapshots});
    };
    front::SweepResult swept =
        options.fronts == 1
            ? sweep_with_snapshots()
            : front::sweep_from_both_ends(skin.surface, guide, sweeping, options.threads, extras);
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

}  // namespace morskin
