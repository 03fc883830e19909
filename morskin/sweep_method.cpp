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

/// Of protecting spheres, for the guards that go by them.
constexpr double enlargement = 3;

morse::ProtectingSpheres enlarged(const skin::SkinSurface& skin, const morse::Guide& guide) {
  std::vector<double> radii;
  for (std::size_t c = 0; c < guide.points.size(); ++c) {
    radii.push_back(enlargement * guide.spheres.radius(morse::CriticalId{c}));
  }
  return morse::protecting_spheres(skin, guide.points, std::move(radii));
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
    front::SweepOptions sweeping{.sizing = laid,
                                 .guard = options.guard,
                                 .progress = [&](double share) { progress("sweep", share); },
                                 .snapshot_values = options.snapshot_values,
                                 .snapshots = options.snapshots,
                                 .snapshot = options.snapshot};
    if (options.guard != front::Guard::Everywhere) {
      sweeping.enlarged = enlarged(skin.surface, guide);
    }
    if (options.sizing.is_coarser_than_laid()) sweeping.coarser = options.sizing;
    front::SweepResult swept =
        options.fronts == 1
            ? front::sweep_once(skin.surface, guide, sweeping)
            : front::sweep_from_both_ends(skin.surface, guide, sweeping, options.threads);
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
