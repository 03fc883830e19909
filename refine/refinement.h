#pragma once

/// Local refinement (section 4.3): edge flips keep the mesh the restricted Delaunay triangulation
/// of its vertices, contraction removes edges too short for [L], insertion breaks triangles too big
/// for [U], until neither is left. Where [U] alone does not imply the certificate's conditions (c1)
/// and (c2), insertion breaks what does not meet these as well.
///
/// Contraction deletes one end of the edge and never moves a vertex, insertion takes the centre of
/// the triangle's surface ball. So the number of pairs closer than [L] allows never grows, as long
/// as Q^2 > 2 + 4 C Q, and the process ends (papers/4.3-local-refinement.md).

#include <array>
#include <vector>

#include "geometry/progress.h"
#include "refine/ball_pencil.h"
#include "refine/sizing.h"
#include "refine/sure_edges.h"
#include "refine/triangle_geometry.h"

namespace morskin::refine {

struct RefinementCounts {
  std::size_t flip = 0;
  std::size_t contract = 0;
  std::size_t insert = 0;
  std::size_t refused = 0;  ///< edges and triangles that stayed in breach of [L] or [U]
};

class Refinement {
 public:
  /// @param threads  at most, for the first look at the mesh; the outcome is the same for any
  ///                 number
  /// @pre the mesh is closed, its vertices are points of the skin.
  Refinement(const skin::SkinSurface& skin, const Sizing& sizing, SkinMesh& mesh,
             unsigned threads = 1);

  /// Refines until [L] and [U] hold, or nothing more can be done. The mesh comes out compacted.
  /// @param told  the share of edges and triangles in breach so far that have been looked at
  void run(const geometry::Told& told = {});

  const RefinementCounts& counts() const { return counts_; }

 private:
  /// What needs work.
  struct Work {
    std::vector<HalfEdgeId> to_flip;    ///< edges that may not be Delaunay
    std::vector<HalfEdgeId> too_short;  ///< edges that broke [L] when they came to be
    std::vector<TriangleId> big;        ///< triangles that broke [U] when they came to be

    void append(const Work& other);
  };

  void look_everywhere();
  double most_residual(const std::array<const SurfacePoint*, 3>& corners) const;
  void look_for_flips(std::size_t begin, std::size_t end, const SureEdges& sure, Work& found) const;
  Circumcircle update(TriangleId t, Work& found);
  void update_after_change(TriangleId t, std::initializer_list<HalfEdgeId> edges);
  void flip_where_needed();
  bool flip_if_better(HalfEdgeId h);
  void flip(HalfEdgeId h);
  void contract_short_edges();
  bool contract(HalfEdgeId h);
  bool remove(VertexId v);
  std::optional<HalfEdgeId> last_flip(VertexId v) const;
  void insert_into_big_triangles();
  bool insert(TriangleId t);
  void tell(std::size_t left);

  bool is_short(HalfEdgeId h) const;
  bool is_big(TriangleId t, const Circumcircle& circle) const;
  bool faces_outward(VertexId a, VertexId b, VertexId c) const;
  bool can_flip(HalfEdgeId h) const;
  QuestionedBall ball(VertexId a, VertexId b, VertexId c) const;
  std::array<const SurfacePoint*, 3> points(TriangleId t) const {
    const auto [a, b, c] = mesh_.surface.corners(t);
    return {&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)};
  }

  const skin::SkinSurface& skin_;
  const Sizing sizing_;
  SkinMesh& mesh_;
  const unsigned threads_;
  Work work_;
  /// Budgets, for constants outside the range where termination is proved: of contractions and
  /// insertions together, one for every triangle of the front's mesh, of which a few in a hundred
  /// are usual; and 50 flips for every triangle there has been.
  std::size_t most_ = 0;
  RefinementCounts counts_;
  geometry::Told told_;
  std::size_t steps_ = 0;
};

}  // namespace morskin::refine
