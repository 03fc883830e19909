#pragma once

/// Coarsening turns a fine mesh into one for a larger C: it removes vertices as long as [U] holds
/// and the certificate could still prove every triangle. Each removal leaves a valid mesh, so
/// coarsening assumes nothing about where the front laid its vertices, and no front is laid with a
/// C for which nothing is proved (papers/4.3-large-molecules.md).
///
/// Refinement contracts edges because [L] demands it, and mends the triangles by insertion.
/// Coarsening expects [L] and [U] to hold already at all but a few vertices.

#include <vector>

#include "refine/mesh_operations.h"

namespace morskin::refine {

class Coarsening {
 public:
  /// @param sizing  what the mesh is to meet
  /// @param limit   the share of [U] up to which vertices are removed that may stay
  /// @param mesh    vertices are points of the surface; may have a boundary, and may grow, be
  ///                compacted or have another appended between runs
  Coarsening(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
             double limit = Sizing::spare_limit);

  /// Tries the vertices that are new since the last run or had to wait. Removes first those nearer
  /// to a neighbour than [L] allows, then others while all triangles stay below the limit. Ids stay
  /// free until the mesh is compacted.
  /// @param subdomain  only vertices that it contains with their neighbours are removed; the others
  ///                   wait. The whole mesh if that is closed.
  /// @return the number removed
  std::size_t run(const Subdomain& subdomain = {});

 private:
  bool is_removed(VertexId v) const { return !mesh_.surface.outgoing(v); }
  std::vector<VertexId> candidates(const Subdomain& subdomain);
  void prefetch_next(const std::vector<VertexId>& pass, std::size_t i) const;
  bool is_crowded_after(VertexId v, double limit, const Subdomain& subdomain);
  bool remove(VertexId v, double limit);
  double ear(VertexId a, VertexId b, VertexId c, double limit) const;
  bool can_be_proved(VertexId a, VertexId b, VertexId c) const;

  const surface::Surface& surface_;
  const Sizing sizing_;
  const double limit_;
  Mesh& mesh_;
  /// Vertices that a run has tried: neither new nor waiting.
  geometry::VertexData<char> is_tried_;
  std::size_t removed_ = 0;
  std::vector<VertexId> crowd_;  ///< neighbours of a vertex that are too near
  VertexRemoval removal_;
};

}  // namespace morskin::refine
