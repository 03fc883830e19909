#include "morskin/method.h"

#include <algorithm>

namespace morskin {

MethodResult run_method(const PreparedSkin& skin, const MeshingOptions& options, Observer& observer,
                        const Run& run) {
  if (options.mesher) return options.mesher(skin, options, observer, run);
  MethodResult made = options.method == Method::Sweep ? sweep_method(skin, options, observer, run)
                                                      : static_method(skin, options, observer, run);
  if (made.open_edges > 0 || options.angle_goal_deg == 0) return made;
  made.smoothing = run.stage("smooth", [&] {
    return refine::smooth(skin.surface, options.sizing, made.mesh, options.angle_goal_deg, run);
  });
  if (made.smoothing.left > 0) {
    made.improvement = run.stage("improve angles", [&] {
      return refine::improve_angles(skin.surface, options.sizing, made.mesh, options.angle_goal_deg,
                                    run);
    });
  }
  made.angles = run.stage("refine angles", [&] {
    const double bound = std::min(options.angle_goal_deg, guaranteed_angle_deg);
    return refine::refine_angles(skin.surface, options.sizing, made.mesh, bound, run);
  });
  return made;
}

}  // namespace morskin
