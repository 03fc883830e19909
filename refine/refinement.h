#pragma once

/// Local refinement (section 4.3): edge flips keep the mesh the restricted Delaunay triangulation
/// of its vertices, contraction removes edges too short for [L], insertion breaks triangles too big
/// for [U], until neither is left. Where [U] alone does not imply the certificate's conditions (c1)
/// and (c2), insertion breaks what does not meet these as well.

#include "refine/local_operations.h"

namespace morskin::refine {

class Refinement {
 public:
  /// @param run  receives the share processed of the edges and triangles found in breach so far
  /// @pre the mesh is closed, its vertices are points of the skin.
  Refinement(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
             const geometry::Run& run = geometry::Run());

  /// Refines until [L] and [U] hold, or nothing more can be done. The mesh comes out compacted.
  void run();
  /// The same for a mesh that is restricted Delaunay and has no triangle that is too big: only
  /// edges too short for [L] are looked for.
  void run_from_short_edges();

  RefinementCounts counts() const;
  /// Whether there are triangles that break [U], or that the certificate could not prove.
  bool leaves_big_triangles() const { return !operations_.work().big.empty(); }

 private:
  void inspect_all();
  void finish();
  void find_flips(std::size_t begin, std::size_t end, const DelaunayFilter& filter,
                  Work& found) const;
  void insert_by_boxes();
  std::vector<SurfaceMesh::FreeSlots> new_slots(std::size_t count);

  Mesh& mesh_;
  const surface::Surface& surface_;
  const Sizing sizing_;
  const geometry::Run run_;
  LocalOperations operations_;  ///< on the whole mesh
  /// A budget, for constants outside the range where termination is proved: of contractions and
  /// insertions together, one for every triangle of the front's mesh, of which a few in a hundred
  /// are usual.
  const std::size_t max_operations_;
};

}  // namespace morskin::refine
