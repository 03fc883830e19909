#pragma once

/// How many vertices a mesh shall have. The number follows from the sizing and the skin's length
/// scales; where it has to be met, trial meshes find the sizing that has it.

#include <optional>

#include "certify/sizing.h"
#include "geometry/run.h"

namespace morskin {

struct PreparedSkin;
struct MeshingOptions;

/// At most one of these.
struct SizeGoal {
  std::optional<double> density;    ///< vertices per square Angstrom
  std::optional<double> triangles;  ///< in all

  bool is_set() const { return density || triangles; }
};

/// Sets the largest length scale of the sizing, with which a mesh has what the size goal asks for,
/// within a few per cent; without a limit where C allows no mesh so coarse. Sets the method too,
/// where none is asked for.
///
/// Trial meshes are made until one fits, without smoothing, the first as coarse as C allows. With
/// A(v) the area about a vertex of one with the limit l, a mesh with the limit m has nearly
///
///     (number now) (sum A(v) / min(rho(v), m)^2) / (sum A(v) / min(rho(v), l)^2)
///
/// vertices, for edges are as long as the lesser of length scale and limit, times a constant.
/// @throws what make_mesh() does
void settle_size(const PreparedSkin& skin, MeshingOptions& options, const geometry::Run& run);

}  // namespace morskin
