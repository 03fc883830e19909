#pragma once

/// How many vertices a mesh shall have. The number follows from the sizing and the skin's length
/// scales, but only nearly: where it is missed, the mesh tells what sizing has it.

#include <optional>

#include "geometry/run.h"

namespace morskin {

class Observer;
struct PreparedSkin;
struct MeshingOptions;
struct MethodResult;

/// At most one of these.
struct SizeGoal {
  std::optional<double> density;    ///< vertices per square Angstrom
  std::optional<double> triangles;  ///< in all

  bool is_set() const { return density || triangles; }
};

/// Meshes with the largest length scale that gives what the size goal asks for, within a few per
/// cent; without a limit where C allows no mesh so coarse. Sets it, and the method.
///
/// The first mesh is by an estimate, and mostly the last. Others are made until one fits. With
/// A(v) the area about a vertex of one with the limit l, a mesh with the limit m has nearly
///
///     (number now) (sum A(v) / min(rho(v), m)^2) / (sum A(v) / min(rho(v), l)^2)
///
/// vertices, for edges are as long as the lesser of length scale and limit, times a constant.
/// @throws what make_mesh() does
MethodResult mesh_of_size(const PreparedSkin& skin, MeshingOptions& options, Observer& observer,
                          const geometry::Run& run);

}  // namespace morskin
