#include "bench/ablation/as_printed.h"

#include <limits>
#include <vector>

#include "bench/ablation/contraction_by_distance.h"
#include "bench/ablation/refining_observer.h"
#include "front/experimental_guards.h"
#include "front/sweep.h"
#include "front/sweep_plan.h"
#include "morse/make_guide.h"

namespace morskin::ablation {

namespace {

morse::Guide make_guide(const PreparedSkin& skin, const MeshingOptions& options,
                        const AsPrinted& printed, const Run& run) {
  const morse::Contraction contract =
      printed.contraction ? contract_by_distance : morse::contract_short_arcs;
  return morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(),
                           options.function, sphere_share(skin.surface, options.sizing), run,
                           contract);
}

/// Sweeps once from below into the mesh.
/// @return the front edges left open
std::size_t sweep(const PreparedSkin& skin, const morse::Guide& guide,
                  const MeshingOptions& options, const AsPrinted& printed, surface::Mesh& mesh) {
  front::SweepOptions sweeping{.sizing = options.sizing, .spacing = spacing(printed)};
  const front::NarrowGuard in_spheres(guide.spheres, false);
  if (printed.guard) sweeping.guard = &in_spheres;
  RefiningObserver refining(skin.surface, options.sizing, mesh);
  std::vector<front::SweepObserver*> observers;
  if (printed.refinement) observers.push_back(&refining);
  front::Sweep sweep(skin.surface, guide, sweeping, mesh, observers);
  sweep.run({}, front::minima_of(guide));
  return sweep.open_edges();
}

}  // namespace

front::Spacing spacing(const AsPrinted& printed) {
  front::Spacing spacing;
  if (printed.radius) {
    spacing.disk_share = 1;
    spacing.fan_share = std::numeric_limits<double>::infinity();
  }
  if (printed.length_scale) spacing.is_by_both_ends = false;
  if (printed.sectors) spacing.rounds_up = true;
  if (printed.wings) spacing.wing_angle_deg = 90;
  if (printed.edges) {
    spacing.largest_ear = std::numeric_limits<double>::infinity();
    spacing.longest_edge = std::numeric_limits<double>::infinity();
  }
  return spacing;
}

Mesher mesher(const AsPrinted& printed) {
  return [printed](const PreparedSkin& skin, const MeshingOptions& options, Observer& observer,
                   const Run& run) {
    MethodResult result;
    const morse::Guide guide = make_guide(skin, options, printed, run);
    result.function = guide.function;
    result.open_edges = sweep(skin, guide, options, printed, result.mesh);
    observer.swept(result.mesh);
    if (result.open_edges > 0) return result;
    refine::Refinement refinement(skin.surface, options.sizing, result.mesh, run);
    refinement.run();
    result.refinement = refinement.counts();
    return result;
  };
}

}  // namespace morskin::ablation
