#include "morskin/method.h"

#include <algorithm>
#include <utility>

namespace morskin {

MethodResult run_method(const PreparedSkin& skin, const MeshingOptions& options, Observer& observer,
                        const Run& run) {
  if (options.mesher) return options.mesher(skin, options, observer, run);
  MethodResult made = options.method == Method::Sweep ? sweep_method(skin, options, observer, run)
                                                      : static_method(skin, options, observer, run);
  if (made.open_edges > 0 || options.goal_deg() == 0) return made;
  // So much more than asked, in degrees, that rounding cannot bring a file's angle below.
  constexpr double margin_deg = 1e-9;
  const double goal_deg = options.goal_deg() + margin_deg;
  const auto goal = refine::AngleGoal::with(goal_deg, options.sizing);
  made.smoothing = run.stage(
      "smooth", [&] { return refine::smooth(skin.surface, options.sizing, made.mesh, goal, run); });
  if (made.smoothing.left > 0) {
    made.improvement = run.stage("improve angles", [&] {
      return refine::improve_angles(skin.surface, options.sizing, made.mesh, goal, run);
    });
  }
  if (made.below_goal() == 0) return made;
  const double bound_deg = std::min(goal_deg, certify::guaranteed_angle_deg + margin_deg);
  made.angles = run.stage("refine angles", [&] {
    return refine::refine_angles(skin.surface, options.sizing, made.mesh, bound_deg, run);
  });
  if (made.angles.left > 0) {
    run.stage("refine angles in space", [&] {
      auto refined = refine_angles_in_space(skin, made.mesh, options.sizing, bound_deg, run);
      if (refined) made.mesh = std::move(*refined);
    });
  }
  return made;
}

}  // namespace morskin
