#pragma once

/// The seam between a way of meshing and everything round it: a prepared skin and options in, a
/// skin mesh with its counts out. The sweep of the paper and what it is compared with plug in here.

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "front/experimental_guards.h"
#include "front/operation_counter.h"
#include "front/snapshots.h"
#include "geometry/progress.h"
#include "morse/choose_function.h"
#include "refine/refinement.h"
#include "refine/smoothing.h"
#include "skin/dual_complex.h"

namespace morskin {

/// How a skin is meshed.
enum class Method {
  Sweep,          ///< Algorithm 1 of the paper: an advancing front along a Morse function
  Static,         ///< restricted Delaunay refinement (papers/5-static.md)
  Dynamic,        ///< growth from nothing; lives outside the library, see MeshOptions::mesher
  MarchingCubes,  ///< of G on a grid, without any quality; outside the library as well
};

/// The method called "sweep", "static", "dynamic" or "marching-cubes"; nothing for other words.
std::optional<Method> parse_method(std::string_view name);
std::string_view name_of(Method method);

/// Called from one thread at a time, not always the same.
using geometry::Progress;

/// The skin that a mesh is made of, with its topology: built once, used to mesh and to certify.
struct PreparedSkin {
  skin::SkinSurface surface;
  skin::DualComplex topology;
};

/// Seconds by stage, by the wall clock.
struct StageSeconds {
  double triangulate = 0, mixed_complex = 0, critical_points = 0;
  double sweep = 0;  ///< or what another method does in its place
  double refine = 0, smooth = 0, certify = 0;
};

/// What a method tells of its run.
struct RunCounts {
  std::size_t minima = 0, saddles = 0, maxima = 0;
  /// What the simplification left of them.
  std::size_t surviving_minima = 0, surviving_saddles = 0, surviving_maxima = 0;
  morse::MorseFunction function;  ///< the one used
  front::Operations operations;   ///< of the sweep
  refine::RefinementCounts refinement;
  refine::SmoothingCounts smoothing;
  std::size_t open_edges = 0;  ///< of a surface that could not be closed; 0 in a good mesh
  StageSeconds seconds;
};

/// What a method hands back. With open edges the mesh is unfinished and stays so.
struct MethodResult : RunCounts {
  surface::Mesh mesh;
};

struct MeshOptions;
/// A way of meshing. It throws what `mesh_skin` does.
using Mesher = std::function<MethodResult(const PreparedSkin&, const MeshOptions&)>;

struct MeshOptions {
  certify::Sizing sizing;
  /// Degrees. Meshes of the sweep and of the static method are smoothed until no angle is smaller,
  /// as far as that can be done under [L] and [U]; 0 leaves them as they are.
  double angle_goal_deg = 30;
  Method method = Method::Sweep;
  /// What to run in place of `method`'s own; must be given for a method outside the library.
  Mesher mesher;
  /// The function to sweep along; without one, the height y with a small tilt, and further tilts
  /// should that be degenerate.
  std::optional<morse::MorseFunction> function;
  /// 2: swept from both ends at once; 1: from below only, Algorithm 1 as printed.
  int fronts = 2;
  front::Guard guard = front::Guard::Everywhere;
  /// With one front: see front::Snapshots.
  std::vector<double> snapshot_values;
  std::size_t snapshots = 0;
  std::function<void(const front::Snapshot&)> snapshot;
  unsigned threads = 2;  ///< at most; the mesh is the same for any number
  /// Certify the mesh in memory. The command does without: it certifies the bytes it wrote.
  bool certify = true;
  Progress progress;  ///< may be empty
};

/// What runs for these options.
/// @throws geometry::RefusedInput for a method without a mesher
Mesher mesher_of(const MeshOptions& options);

/// That mesher, and smoothing behind the methods of the library.
MethodResult run_method(const PreparedSkin& skin, const MeshOptions& options);

/// Of protecting spheres over the length scale: as the front's disks, also on the largest ball.
double sphere_share(const skin::SkinSurface& skin, const certify::Sizing& sizing);

/// Restricted Delaunay refinement (front/static_method.h), then contraction.
/// @throws morse::DegenerateFunction
MethodResult static_method(const PreparedSkin& skin, const MeshOptions& options);

/// The sweep, then refinement.
/// @throws morse::DegenerateFunction
MethodResult sweep_method(const PreparedSkin& skin, const MeshOptions& options);

}  // namespace morskin
