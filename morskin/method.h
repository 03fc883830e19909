#pragma once

/// The seam between a way of meshing and everything round it: a prepared skin and options in, a
/// skin mesh with its counts out. The sweep of the paper and what it is compared with plug in here.

#include <array>
#include <functional>
#include <optional>
#include <span>

#include "front/experimental_guards.h"
#include "front/operation_counter.h"
#include "morse/choose_function.h"
#include "morskin/grading.h"
#include "morskin/mesh_method.h"
#include "morskin/observer.h"
#include "morskin/prepared_skin.h"
#include "morskin/size_goal.h"
#include "refine/angle_improvement.h"
#include "refine/angle_refinement.h"
#include "refine/refinement.h"
#include "refine/smoothing.h"
#include "refine/thinning.h"

namespace morskin {

/// Critical points by index: minima, saddles, maxima.
using CriticalCounts = std::array<std::size_t, 3>;

inline long euler_characteristic(const CriticalCounts& counts) {
  return static_cast<long>(counts[0] + counts[2]) - static_cast<long>(counts[1]);
}

/// What a method counts of its run.
struct RunCounts {
  CriticalCounts critical_points{};
  CriticalCounts surviving_points{};  ///< those that the simplification left
  morse::MorseFunction function;      ///< the one used
  front::Operations operations;       ///< of the sweep
  refine::RefinementCounts refinement;
  refine::SmoothingCounts smoothing;
  refine::AngleImprovementCounts improvement;
  refine::AngleRefinementCounts angles;
  std::size_t open_edges = 0;      ///< of a surface that could not be closed; 0 in a good mesh
  std::size_t subdomains = 1;      ///< that a sweep was made of
  std::size_t triangles_laid = 0;  ///< by it
  std::size_t seam_triangles = 0;  ///< of these, those between subdomains

  /// Triangles that miss the goal in the end.
  std::size_t below_goal() const { return smoothing.left.empty() ? 0 : improvement.left; }
};

/// What a method hands back. With open edges the mesh is unfinished and stays so.
struct MethodResult : RunCounts {
  surface::Mesh mesh;
};

struct MeshingOptions;
/// A way of meshing. It throws what `make_mesh` does.
using Mesher =
    std::function<MethodResult(const PreparedSkin&, const MeshingOptions&, Observer&, const Run&)>;

struct MeshingOptions {
  certify::Sizing sizing;
  SizeGoal size_goal = {};  ///< make_mesh() then sets the sizing's largest length scale
  /// Degrees. Meshes of the sweep and of the static method are smoothed until no angle is smaller,
  /// as far as that can be done under [L] and [U]; 0 leaves them as they are. Without one,
  /// AngleGoal::usual_deg().
  std::optional<double> angle_goal_deg = {};
  /// By how much edges may grow for each Angstrom (grading.h). Where that is less than they would,
  /// the method is the static one. It wants an angle goal of 30 degrees or more.
  std::optional<double> grading = {};
  std::shared_ptr<const surface::SizeField> sizes = {};  ///< make_mesh() makes it of the grading
  std::optional<Method> method = {};                     ///< without one, method_of()
  /// From outside the library, in place of the method: its mesh is left as it is.
  Mesher mesher = {};
  /// The function to sweep along; without one, the height y with a small tilt, and further tilts
  /// should that be degenerate.
  std::optional<morse::MorseFunction> function = {};
  /// So many subdomains are swept each for itself: a power of two up to front::max_subdomains. 1:
  /// one front from below, as in Algorithm 1. Without one, as many as the size of the mesh is
  /// worth.
  std::optional<std::size_t> fronts = {};
  front::Guard guard = front::Guard::Everywhere;
  /// Whether other runs replace what a sweep's certificate does not cover (safety_net.h).
  bool has_safety_net = true;

  double goal_deg() const { return angle_goal_deg.value_or(refine::AngleGoal::usual_deg(sizing)); }
};

/// What meshes best: the sweep, but the static method where triangles are coarse, no limit makes
/// length scales far smaller than the balls, and there are at most 50,000 balls. There the sweep
/// lays three to four times as many as are kept.
/// @pre there is a ball
Method usual_method(std::span<const geometry::WeightedPoint> balls, const certify::Sizing& sizing);
/// The method asked for or, without one, the usual one; the sweep for all that asks for a part of
/// it.
Method method_of(const PreparedSkin& skin, const MeshingOptions& options);

/// Meshes by these options, and smooths what a method of the library has made.
MethodResult run_method(const PreparedSkin& skin, const MeshingOptions& options, Observer& observer,
                        const Run& run);

/// Restricted Delaunay refinement (front/static_method.h), then contraction.
/// @throws morse::DegenerateFunction
MethodResult static_method(const PreparedSkin& skin, const MeshingOptions& options, const Run& run);

/// The vertices of a mesh again, as samples of restricted Delaunay refinement until no facet has a
/// smaller angle: the last resort where refine::refine_angles() leaves triangles. In the stages
/// "triangulate", "mixed complex" and "refine angles in space".
/// @param min_angle_deg  at most 30
/// @return nothing where the facets do not become a surface
std::optional<surface::Mesh> refine_angles_in_space(const PreparedSkin& skin,
                                                    const surface::Mesh& mesh,
                                                    const MeshingOptions& options,
                                                    double min_angle_deg, const Run& run);

/// The sweep, then refinement.
/// @throws morse::DegenerateFunction
MethodResult sweep_method(const PreparedSkin& skin, const MeshingOptions& options,
                          Observer& observer, const Run& run);

}  // namespace morskin
