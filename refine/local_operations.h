#pragma once

/// The operations of local refinement (section 4.3) on a mesh, or on a subdomain of one while
/// others work on the rest: edge flips, contraction, insertion.
///
/// Contraction deletes one end of the edge and never moves a vertex, insertion takes the centre of
/// the triangle's surface ball. So the number of pairs closer than [L] allows never grows and the
/// process ends, as long as Q^2 > 2 + 4 C Q and balls are empty of all vertices; here they are of
/// neighbours, and there are limits (papers/4.3-local-refinement.md).

#include <array>
#include <vector>

#include "geometry/run.h"
#include "refine/journal.h"
#include "refine/mesh_operations.h"

namespace morskin::refine {

struct RefinementCounts {
  std::size_t flip = 0;
  std::size_t contract = 0;
  std::size_t insert = 0;
  std::size_t refused = 0;  ///< edges and triangles that stayed in breach of [L] or [U]
};

/// What needs work.
struct Work {
  std::vector<HalfEdgeId> to_flip;    ///< edges that may not be Delaunay
  std::vector<HalfEdgeId> too_short;  ///< edges that broke [L] when they came to be
  std::vector<TriangleId> big;        ///< triangles that broke [U] when they came to be

  void append(const Work& other);
};

class LocalOperations {
 public:
  /// Does what is to be done in a subdomain. What has to wait for its neighbours stays behind as
  /// work, and the subdomain gives up what lies there.
  /// @param slots  for vertices inserted, the last first. The whole mesh gets more when there is
  ///               none left.
  /// @pre the mesh is closed, its vertices are points of the skin.
  LocalOperations(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh, Work work = {},
                  const Subdomain& subdomain = {}, std::vector<SurfaceMesh::FreeSlots> slots = {});

  /// Reports now and then what share of the work known so far is done; insertions may make more.
  void report_to(const geometry::Run& run) { run_ = run; }

  /// Notes all changes from now on.
  void record_in(Journal& journal) { journal_ = &journal; }

  /// From now on no flip is made that leaves a triangle too big, where no vertex is to break it.
  void keep_sizes() { keeps_sizes_ = true; }

  void flip_where_needed();
  /// Takes a vertex out, if what it leaves can be covered by triangles that face outward. Edges
  /// that ought to be flipped then are left as work.
  bool remove(VertexId v);
  /// Breaks a triangle with the centre of its surface ball, if that goes in where `may_go` allows
  /// it. Edges that ought to be flipped then are left as work.
  /// @tparam MayGo  Insertion -> bool
  template <class MayGo>
  bool insert_ball_centre(TriangleId t, const MayGo& may_go);
  void contract_short_edges();
  void insert_into_big_triangles(std::size_t max_insertions);

  /// Adds what another has done, what it deferred, and its free slots.
  void absorb(const LocalOperations& other);

  /// Notes a triangle that breaks [U], and edges of it that break [L].
  void inspect(TriangleId t, Work& found) const;
  LazySurfaceBall ball(VertexId a, VertexId b, VertexId c) const;
  /// |G| at the corners of a triangle is at most this, Angstrom^2.
  double max_residual(const surface::Corners& corners) const;

  std::vector<SurfaceMesh::FreeSlots>& free_slots() { return free_slots_; }
  Work& work() { return work_; }
  const Work& work() const { return work_; }
  const RefinementCounts& counts() const { return counts_; }

 private:
  void inspect_again(TriangleId t, std::initializer_list<HalfEdgeId> edges);
  bool flip_if_better(HalfEdgeId h);
  void defer(HalfEdgeId h);
  bool contract(HalfEdgeId h);
  bool insert(TriangleId t);
  void insert(const Insertion& where);
  void report_progress(std::size_t left);

  bool is_short(HalfEdgeId h) const;
  bool is_big(const surface::Corners& p) const;
  bool is_big(VertexId a, VertexId b, VertexId c) const;
  auto points() const {
    return [this](VertexId v) -> const SurfacePoint& { return mesh_.at(v); };
  }
  void note_flip(HalfEdgeId h);

  const surface::Surface& surface_;
  const Sizing sizing_;
  Mesh& mesh_;
  Work work_, deferred_;  ///< to do; for whoever absorbs this
  Subdomain subdomain_;
  std::vector<SurfaceMesh::FreeSlots> free_slots_;
  RefinementCounts counts_;
  VertexRemoval removal_;
  bool keeps_sizes_ = false;
  Journal* journal_ = nullptr;
  std::optional<geometry::Run> run_;  ///< to report to
  std::size_t steps_ = 0;
};

// Below the class: clang wants the type of points() deduced before its use.
template <class MayGo>
bool LocalOperations::insert_ball_centre(TriangleId t, const MayGo& may_go) {
  const auto may_cross = [&](HalfEdgeId h) {
    return subdomain_.contains(mesh_.surface.origin(h)) ||
           subdomain_.contains(mesh_.surface.target(h));
  };
  const auto where = find_insertion(surface_, mesh_.surface, points(), t, may_cross);
  if (!where || !subdomain_.contains(mesh_.surface, where->under) || !may_go(*where)) return false;
  insert(*where);
  return true;
}

}  // namespace morskin::refine
