#include "morskin/method.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "morskin/pipeline_parts.h"
#include "morskin/voids.h"
#include "skin/model.h"

namespace morskin {

Method usual_method(std::span<const geometry::WeightedPoint> balls, const certify::Sizing& sizing) {
  // Measured (bench/MEASUREMENTS.md): beyond this C the static method makes as dense a mesh in less
  // time, unless most edges are far shorter than the atoms' radii would have them. It takes 14 kB
  // an atom, so the largest are left to the sweep.
  constexpr double coarse_C = 0.25, limiting_share = 0.25;
  constexpr std::size_t most_balls = 50'000;
  if (sizing.C <= coarse_C || balls.size() > most_balls) return Method::Sweep;
  std::vector<double> weights;
  for (const geometry::WeightedPoint& p : balls) weights.push_back(p.weight);
  const auto median = weights.begin() + static_cast<std::ptrdiff_t>(weights.size() / 2);
  std::nth_element(weights.begin(), median, weights.end());
  const double usual_patch = skin::patch_radius(std::max(*median, 0.0));
  const bool is_by_length = sizing.largest_length_scale < limiting_share * usual_patch;
  return is_by_length ? Method::Sweep : Method::Static;
}

Method method_of(const PreparedSkin& skin, const MeshingOptions& options) {
  const bool is_of_the_sweep = options.fronts || options.guard != front::Guard::Everywhere;
  if (options.method) return *options.method;
  if (options.mesher || is_of_the_sweep) return Method::Sweep;
  return usual_method(skin.surface.points(), options.sizing);
}

namespace {

/// So much more than asked, in degrees, that rounding cannot bring a file's angle below.
constexpr double angle_margin_deg = 1e-9;

/// Below which angles are raised by insertions where moves do not.
double angle_bound_deg(const MeshingOptions& options) {
  return std::min(options.goal_deg(), certify::guaranteed_angle_deg) + angle_margin_deg;
}

/// How many triangles of a mesh miss a goal.
std::size_t count_missing(const surface::Mesh& mesh, const refine::AngleGoal& goal) {
  std::size_t missing = 0;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const geometry::TriangleId id{t};
    missing += !mesh.surface.is_removed(id) && !goal.is_met(mesh, id);
  }
  return missing;
}

/// Counts anew the triangles that miss the goal, once insertions have changed the mesh.
void count_below_goal(const MeshingOptions& options, MethodResult& made) {
  const auto goal = refine::AngleGoal::with(options.goal_deg(), options.sizing);
  made.improvement.left = count_missing(made.mesh, goal);
}

/// Moves vertices for a goal; where that leaves triangles below it, changes the connectivity too.
void smooth_and_improve(const surface::Surface& sized, const certify::Sizing& sizing,
                        const refine::AngleGoal& goal, int repairs, MethodResult& made,
                        const Run& run) {
  made.smoothing =
      run.stage("smooth", [&] { return refine::smooth(sized, sizing, made.mesh, goal, run); });
  made.improvement = {};
  if (made.smoothing.left.empty()) return;
  made.improvement = run.stage("improve angles", [&] {
    return refine::improve_angles(sized, sizing, made.mesh, goal, made.smoothing.left, run,
                                  repairs);
  });
}

/// Whether a length was asked for, with a C coarser than fronts are laid with.
bool is_thinned(const MeshingOptions& options) {
  const bool is_by_length =
      options.size_goal.is_set() || std::isfinite(options.sizing.largest_length_scale);
  return is_by_length && options.sizing.is_coarser_than_laid() && !options.sizes;
}

}  // namespace

void raise_angles(const surface::Surface& surface, const MeshingOptions& options,
                  MethodResult& made, const Run& run) {
  const SizedSurface sized(surface, options.sizes);
  const double goal_deg = options.goal_deg() + angle_margin_deg;
  const auto goal = refine::AngleGoal::with(goal_deg, options.sizing);
  smooth_and_improve(*sized, options.sizing, goal, 0, made, run);
  made.angles = {};
  if (made.below_goal() == 0) return;
  made.angles = run.stage("refine angles", [&] {
    return refine::refine_angles(*sized, options.sizing, made.mesh, angle_bound_deg(options), run);
  });
  count_below_goal(options, made);
}

namespace {

/// Thins the mesh, then raises its angles. Where that leaves some, the thinned mesh is made finer
/// about these places, ever farther, and its angles are raised from there: the insertions that
/// failed may have left worse triangles.
void thin_and_raise_angles(const PreparedSkin& skin, const MeshingOptions& options,
                           MethodResult& made, const Run& run) {
  constexpr double radius_step = 3, max_radius = 15;  // length scales; some two edges, and a dozen
  run.stage("thin", [&] { refine::thin(skin.surface, options.sizing, made.mesh, run); });
  if (options.goal_deg() == 0) return;
  const surface::Mesh thinned = made.mesh;
  std::vector<geometry::Point> places;
  raise_angles(skin.surface, options, made, run);
  for (double radius = radius_step; radius <= max_radius; radius += radius_step) {
    const std::vector<geometry::Point>& left = made.angles.left;
    if (left.empty()) return;
    places.insert(places.end(), left.begin(), left.end());
    made.mesh = thinned;
    run.stage("thicken", [&] {
      refine::thicken(skin.surface, options.sizing, made.mesh, places, radius, run);
    });
    raise_angles(skin.surface, options, made, run);
  }
}

/// Beyond the C up to which [L] is promised: raises angles further where that left some below the
/// goal, with moves and changes for which [L] is let go. Kept if fewer are left and none of these
/// is below the bound.
void raise_angles_without_L(const PreparedSkin& skin, const MeshingOptions& options,
                            MethodResult& made, const Run& run) {
  constexpr double freedom = 8;  // [L] is weaker by its square
  constexpr int repairs = 2;     // with none a triangle of 1BMF stays below 35 degrees
  if (made.below_goal() == 0 || !options.sizing.is_coarser_than_laid()) return;
  const SizedSurface sized(skin.surface, options.sizes);
  certify::Sizing sizing = options.sizing;  // [U] has the product of C and Q, [L] the quotient
  sizing.C /= freedom;
  sizing.Q *= freedom;
  const auto goal = refine::AngleGoal::with(options.goal_deg() + angle_margin_deg, options.sizing);
  MethodResult raised = made;
  smooth_and_improve(*sized, sizing, goal, repairs, raised, run);
  const refine::AngleGoal bound(angle_bound_deg(options));
  if (raised.below_goal() >= made.below_goal() || count_missing(raised.mesh, bound) > 0) return;
  raised.smoothing.below = made.smoothing.below;
  raised.smoothing.moved += made.smoothing.moved;
  raised.improvement.changed += made.improvement.changed;
  made = std::move(raised);
}

}  // namespace

MethodResult run_method(const PreparedSkin& skin, const MeshingOptions& asked, Observer& observer,
                        const Run& run) {
  const bool is_sweep = method_of(skin, asked) == Method::Sweep;
  MeshingOptions options = asked;
  if (!is_sweep) options.sizing = options.sizing.sampled();
  MethodResult made = options.mesher ? options.mesher(skin, options, observer, run)
                      : is_sweep     ? sweep_method(skin, options, observer, run)
                                     : static_method(skin, options, run);
  if (made.open_edges > 0) return made;
  drop_components(skin, made.mesh, run);
  if (options.mesher) return made;
  if (is_thinned(options)) {
    thin_and_raise_angles(skin, options, made, run);
  } else if (options.goal_deg() > 0) {
    raise_angles(skin.surface, options, made, run);
  }
  if (!made.angles.left.empty()) {
    auto refined = refine_angles_in_space(skin, made.mesh, options, angle_bound_deg(options), run);
    if (!refined) return made;
    made.mesh = std::move(*refined);
    drop_components(skin, made.mesh, run);
    made.angles.left.clear();
    count_below_goal(options, made);
  }
  raise_angles_without_L(skin, options, made, run);
  return made;
}

}  // namespace morskin
