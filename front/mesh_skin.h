#pragma once

/// The one public call of the library: weighted points in; mesh, certificate and counts out.
/// It never prints and never exits.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "front/sweep.h"
#include "geometry/error.h"
#include "geometry/indexed_mesh.h"
#include "geometry/progress.h"
#include "morse/choose_function.h"
#include "refine/certificate.h"
#include "refine/refinement.h"

namespace morskin::front {

/// Called from one thread at a time, not always the same.
using geometry::Progress;

struct MeshOptions {
  refine::Sizing sizing;
  /// The function to sweep along; without one, the height y with a small tilt, and further tilts
  /// should that be degenerate.
  std::optional<morse::MorseFunction> function;
  /// 2: swept from both ends at once; 1: from below only, Algorithm 1 as printed.
  int fronts = 2;
  Guard guard = Guard::Everywhere;
  /// With one front: see SweepOptions.
  std::vector<double> snapshot_values;
  std::size_t snapshots = 0;
  std::function<void(const Snapshot&)> snapshot;
  unsigned threads = 2;  ///< at most; the mesh is the same for any number
  /// Certify the mesh in memory. The command does without: it certifies the bytes it wrote.
  bool certify = true;
  Progress progress;  ///< may be empty
};

/// Seconds by stage, by the wall clock.
struct StageSeconds {
  double triangulate = 0, mixed_complex = 0, critical_points = 0, sweep = 0, refine = 0,
         certify = 0;
};

struct MeshResult {
  geometry::IndexedMesh mesh;
  /// By vertex, the mixed cell it lies in.
  std::vector<geometry::CellId> cells;
  refine::Certificate certificate;  ///< empty unless asked for
  skin::DualComplex expected;
  std::size_t minima = 0, saddles = 0, maxima = 0;
  /// What the simplification left of them.
  std::size_t surviving_minima = 0, surviving_saddles = 0, surviving_maxima = 0;
  morse::MorseFunction function;  ///< the one used
  Operations operations;
  refine::RefinementCounts refinement;
  std::size_t open_edges = 0;  ///< of a front that could not be closed; 0 in a good mesh
  StageSeconds seconds;
};

/// The skin that a mesh is made of, with its topology: built once, used to mesh and to certify.
struct PreparedSkin {
  skin::SkinSurface surface;
  skin::DualComplex topology;
};
/// @param points  coordinates and weights of at most 2^30, Angstrom and Angstrom^2; they are
/// rounded
///                to multiples of 2^-64, the grid of the exact predicates
/// @throws skin::SingularSkin, geometry::RefusedInput
PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points,
                          const Progress& progress = {});

/// @throws morse::DegenerateFunction when options.function is degenerate for this skin.
MeshResult mesh_skin(const PreparedSkin& skin, const MeshOptions& options = {});
/// The same from weighted points.
/// @throws skin::SingularSkin when the skin is singular, geometry::RefusedInput when there is none.
MeshResult mesh_skin(std::vector<geometry::WeightedPoint> points, const MeshOptions& options = {});

/// Seconds to move every vertex of a mesh 0.1 rho along its tangent plane and to locate and project
/// it again from its old cell, once: the floor that no mesher can pass on this machine.
double floor_seconds(const skin::SkinSurface& skin, const MeshResult& result);

}  // namespace morskin::front
