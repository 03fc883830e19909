#pragma once

/// The dynamic baseline as one call: weighted points in; mesh and counts out.

#include "bench/baselines/growth.h"
#include "front/mesh_skin.h"

namespace morskin::baselines {

struct DynamicOptions {
  GrowthOptions growth;
  unsigned threads = 2;  ///< of the last refinement; the mesh is the same for any number
  bool certify = true;
};

struct DynamicResult {
  geometry::IndexedMesh mesh;
  std::vector<geometry::CellId> cells;  ///< by vertex
  refine::Certificate certificate;      ///< empty unless asked for
  GrowthCounts growth;
  /// The mesh that has grown is refined once more at the end, by the operations that all methods
  /// share (refine/refinement.h), for between two looks it may break [L] and [U] a little.
  refine::RefinementCounts refinement;
  double growth_seconds = 0, refine_seconds = 0, certify_seconds = 0;
};

/// The skin of the balls grown by `end`: every weight w + end, on the exact grid.
/// @throws skin::SingularSkin, geometry::RefusedInput
front::PreparedSkin grown_skin(const front::PreparedSkin& skin, double end);

/// @param skin  at time 0
/// @param last  grown_skin(skin, options.growth.end); or skin itself when that is 0
DynamicResult mesh_dynamically(const front::PreparedSkin& skin, const front::PreparedSkin& last,
                               const DynamicOptions& options = {});

}  // namespace morskin::baselines
