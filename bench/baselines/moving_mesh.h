#pragma once

/// A closed mesh on the growing skin. Vertices move only when somebody asks for them: each knows
/// its trajectory, and is computed anew for the time that is set.

#include <cstdint>
#include <optional>
#include <vector>

#include "bench/baselines/trajectory.h"
#include "geometry/surface_mesh.h"
#include "refine/refinement.h"
#include "refine/sizing.h"

namespace morskin::baselines {

using geometry::HalfEdgeId;
using geometry::SurfaceMesh;
using geometry::TriangleId;
using geometry::VertexId;

/// The shares of [L] and [U] at which the growing mesh is mended. Between two looks a simplex may
/// pass them, and even break the conditions a little: up to 0.378 rho, 2.9 times [U], a mesh is
/// still proved to be homeomorphic (papers/certificate.md). The mesh at the end breaks none.
struct Slack {
  double contract_below = 1.03;  ///< R_ab over its bound in [L]
  double insert_above = 0.97;    ///< R_abc over its bound in [U]
  double least_L = 0.85;         ///< the next look comes before the ratio can fall below this
  double most_U = 1.15;          ///< or rise above this
};

class MovingMesh {
 public:
  MovingMesh(const SkinSurface& skin, const refine::Sizing& sizing)
      : skin_(skin), sizing_(sizing), level_(skin, 0), watch_(skin.complex().size(), nobody) {}

  const SurfaceMesh& surface() const { return surface_; }
  SurfaceMesh& surface() { return surface_; }
  const SkinSurface& skin() const { return skin_; }
  const LevelSet& level() const { return level_; }

  void set_time(double t) {
    if (t != now_) level_ = LevelSet(skin_, t);
    now_ = t;
  }
  double time() const { return now_; }

  /// The vertex at the time set; if it was made later than that, where it was made.
  const SurfacePoint& at(VertexId v) {
    if (clock_[v.index()] != now_) move(v);
    return points_[v.index()];
  }
  const Point& position(VertexId v) { return at(v).position; }
  const Trajectory& path(VertexId v) const { return paths_[v.index()]; }
  /// A vertex at a point of the skin at the time set.
  VertexId add_vertex(const SurfacePoint& p);

  /// Asks for the vertices that come into some cells.
  std::uint32_t watch(const std::vector<CellId>& cells);
  /// Those that have come, and perhaps left again or been removed.
  const std::vector<VertexId>& visitors(std::uint32_t watch) const { return visitors_[watch]; }
  /// The watch on a cell.
  std::optional<std::uint32_t> watch_of(CellId cell) const {
    const std::uint32_t w = watch_[cell.index()];
    return w == nobody ? std::nullopt : std::optional(w);
  }

  /// Flips the edge if it is better so, by balls to rounding.
  bool flip_if_better(HalfEdgeId h);
  /// Deletes one end of the edge.
  bool contract(HalfEdgeId h);
  /// Puts the centre of the triangle's surface ball into the mesh, unless an edge to it would have
  /// a ratio to [L] below `least_L`.
  bool insert(TriangleId t, double least_L);

  /// Triangles that these operations have changed, for the caller to empty.
  std::vector<TriangleId> changed;
  refine::RefinementCounts counts;

 private:
  static constexpr std::uint32_t nobody = 0xFFFFFFFFU;

  void move(VertexId v);
  void enter(VertexId v, CellId cell) {
    const std::uint32_t w = watch_[cell.index()];
    if (w != nobody) visitors_[w].push_back(v);
  }
  bool faces_outward(VertexId a, VertexId b, VertexId c);
  bool can_flip(HalfEdgeId h);
  void flip(HalfEdgeId h);
  bool remove(VertexId v);
  refine::SurfaceBall exact_ball(VertexId a, VertexId b, VertexId c) {
    return refine::exact_surface_ball(level_, at(a), position(b), position(c));
  }

  const SkinSurface& skin_;
  const refine::Sizing sizing_;
  LevelSet level_;
  double now_ = 0;
  SurfaceMesh surface_;
  // By vertex.
  std::vector<SurfacePoint> points_;
  std::vector<double> clock_;  ///< of what points_ says
  std::vector<Trajectory> paths_;

  // Of a removal: the neighbours left, those cut off, and the edge to the next of these.
  std::vector<VertexId> link_, cuts_;
  HalfEdgeId to_cut_;

  std::vector<std::uint32_t> watch_;  ///< by cell
  std::vector<std::vector<VertexId>> visitors_;
};

}  // namespace morskin::baselines
