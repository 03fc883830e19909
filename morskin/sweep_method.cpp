#include "front/subdomains.h"
#include "morse/make_guide.h"
#include "morse/skin_spheres.h"
#include "morskin/pipeline_parts.h"

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

front::SweepResult sweep(const surface::Surface& surface, const morse::Guide& guide,
                         const MeshingOptions& options, const front::GuardPolicy* guard,
                         Observer& observer, const Run& run) {
  front::SweepOptions sweeping{.sizing = options.sizing.laid(),
                               .record_births = observer.wants_births()};
  if (guard != nullptr) sweeping.guard = guard;
  std::optional<front::CoarseningOptions> coarsening;
  if (options.sizing.is_coarser_than_laid()) coarsening = {.sizing = options.sizing};
  return options.fronts == 1
             ? front::sweep_once(surface, guide, sweeping, coarsening, observer.sweep_observers(),
                                 run)
             : front::sweep_subdomains(surface, guide, sweeping, coarsening, run, options.fronts);
}

}  // namespace

MethodResult sweep_along(const surface::Surface& surface, const morse::Guide& guide,
                         const MeshingOptions& options, const front::GuardPolicy* guard,
                         Observer& observer, const Run& run) {
  MethodResult result;
  observer.guided(guide);
  result.function = guide.function;
  result.critical_points = guide.found;
  for (int index = 0; index < 3; ++index) {
    result.surviving_points[static_cast<std::size_t>(index)] = guide.count(index);
  }
  run.stage("sweep", [&] {
    front::SweepResult swept = sweep(surface, guide, options, guard, observer, run);
    result.mesh = std::move(swept.mesh);
    result.operations = swept.operations;
    result.open_edges = swept.open_edges;
    result.subdomains = swept.subdomains;
    result.triangles_laid = swept.triangles_laid;
    result.seam_triangles = swept.seam_triangles;
  });
  observer.swept(result.mesh);
  if (result.open_edges > 0) return result;
  run.stage("refine", [&] {
    refine::Refinement refinement(surface, options.sizing, result.mesh, run);
    refinement.run();
    result.refinement = refinement.counts();
  });
  return result;
}

MethodResult sweep_method(const PreparedSkin& skin, const MeshingOptions& options,
                          Observer& observer, const Run& run) {
  const morse::Guide guide =
      morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), options.function,
                        sphere_share(skin.surface, options.sizing.laid()), run);
  const auto guard = experimental_guard(options.guard, skin.surface, guide);
  return sweep_along(skin.surface, guide, options, guard ? &*guard : nullptr, observer, run);
}

}  // namespace morskin
