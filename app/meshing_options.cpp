#include "app/meshing_options.h"

#include <algorithm>

#include "app/snapshots.h"
#include "bench/baselines/dynamic_skin.h"
#include "bench/baselines/marching_cubes.h"

namespace morskin::app {
namespace {

// The dynamic method. The balls have been grown to --grow's end already, so it ends at time 0.
morskin::Mesher dynamic_mesher(const morskin::PreparedSkin& skin, const MeshArguments& arguments,
                               StagedOutputs& outputs, MeshReport& report) {
  baselines::GrowthOptions growth;
  double largest = 0;
  for (const auto& p : skin.surface.points()) largest = std::max(largest, p.weight);
  const double from =
      arguments.growth_shown_from ? *arguments.growth_shown_from - arguments.grow_to : -largest;
  for (std::size_t k = 1; k <= arguments.snapshots; ++k) {
    const double left = static_cast<double>(arguments.snapshots - k);
    growth.snapshot_times.push_back(from * left / static_cast<double>(arguments.snapshots));
  }
  for (const double t : arguments.snapshot_values) {
    growth.snapshot_times.push_back(t - arguments.grow_to);
  }
  std::ranges::sort(growth.snapshot_times);
  growth.snapshot = [&arguments, &outputs, number = std::size_t{0}](
                        double, const surface::Mesh& mesh) mutable {
    outputs.undisturbed([&] { write_snapshot(arguments.snapshot_folder, ++number, mesh); });
  };
  return baselines::dynamic_mesher(growth, &report.growth.emplace());
}

}  // namespace

morskin::MeshingOptions options_of(const morskin::PreparedSkin& skin,
                                   const MeshArguments& arguments, StagedOutputs& outputs,
                                   MeshReport& report) {
  morskin::MeshingOptions options;
  options.sizing = arguments.sizing;
  options.size_goal = arguments.size_goal;
  options.grading = arguments.grading;
  options.angle_goal_deg = arguments.angle_goal_deg;
  options.function = arguments.function;
  options.fronts = arguments.fronts;
  options.guard = arguments.guard;
  switch (arguments.method) {
    case MeshMethod::Auto:
      break;
    case MeshMethod::Sweep:
      options.method = morskin::Method::Sweep;
      break;
    case MeshMethod::Static:
      options.method = morskin::Method::Static;
      break;
    case MeshMethod::Dynamic:
      options.mesher = dynamic_mesher(skin, arguments, outputs, report);
      options.has_safety_net = false;
      break;
    case MeshMethod::MarchingCubes:
      report.grid_step = arguments.grid_step
                             ? *arguments.grid_step
                             : baselines::step_like_sweep(skin.surface, report.sizing);
      options.mesher = baselines::marching_cubes_mesher(*report.grid_step);
      options.has_safety_net = false;
      break;
  }
  return options;
}

}  // namespace morskin::app
