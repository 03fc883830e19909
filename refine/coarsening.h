#pragma once

/// Coarsening: makes a mesh with a larger C out of one that was laid finer, by taking vertices out
/// for as long as [U] holds and the certificate could still prove every triangle. Each step leaves
/// a mesh as good as the last, so nothing has to be right about where the front laid its vertices,
/// and no front has to be laid where nothing is proved of it (papers/4.3-large-molecules.md).
///
/// Contraction in refinement also takes vertices out, but because [L] demands it, whatever becomes
/// of the triangles; what it breaks is then mended by insertion. Here [L] and [U] are both met
/// beforehand for all but a few vertices.

#include <cstdint>
#include <vector>

#include "refine/mesh_operations.h"

namespace morskin::refine {

class Coarsening {
 public:
  /// @param sizing  what the mesh is to meet
  /// @param mesh    vertices are points of the surface; may have a boundary, and may grow, be
  ///                compacted or have another appended between runs
  Coarsening(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh);

  /// Tries the vertices that are new since the last run and those that had to wait, and takes out
  /// what can be spared: first those nearer to a neighbour than [L] allows, then others as long as
  /// all triangles stay well below [U]. Ids stay free until the mesh is compacted.
  /// @param subdomain  whose vertices it may take out, if it has their neighbours too; the others
  ///                   wait. The whole mesh if that is closed.
  /// @return how many it took out
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
  Mesh& mesh_;
  /// Vertices that a run has tried: neither new nor waiting.
  geometry::VertexData<char> is_tried_;
  std::size_t removed_ = 0;
  std::vector<VertexId> crowd_;  ///< neighbours of a vertex that are too near
  VertexRemoval removal_;
};

}  // namespace morskin::refine
