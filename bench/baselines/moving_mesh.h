#pragma once

/// A closed mesh on the growing skin. Vertices move only when they are read: each knows
/// its trajectory, and is computed anew for the time that is set.

#include <cmath>
#include <optional>
#include <vector>

#include "bench/baselines/trajectory.h"
#include "certify/sizing.h"
#include "geometry/mesh_data.h"
#include "geometry/surface_mesh.h"
#include "refine/mesh_operations.h"
#include "refine/refinement.h"

namespace morskin::baselines {

using geometry::HalfEdgeId;
using geometry::SurfaceMesh;
using geometry::TriangleId;
using geometry::VertexId;

/// The shares of [L] and [U] at which the growing mesh is mended. Between two inspections a simplex
/// may pass them, and even break the conditions a little: up to 0.378 rho, 2.9 times [U], a mesh is
/// still proved to be homeomorphic (papers/certificate.md). The mesh at the end breaks none.
struct Slack {
  double contract_below = 1.03;  ///< R_ab over its bound in [L]
  double insert_above = 0.97;    ///< R_abc over its bound in [U]
  double min_L = 0.85;           ///< the next inspection comes before the ratio can fall below
  double max_U = 1.15;           ///< or rise above
};

/// Distance of neighbouring points of special sampling over the length scale: this share of the
/// longest edge that an equilateral triangle may have under [U], sqrt(3) C Q. The shortest that [L]
/// allows, 2 C / Q, is 0.42 of that edge.
inline constexpr double template_share = 0.79;
/// That longest edge, over the length scale.
inline double longest_edge(const certify::Sizing& sizing) {
  return std::sqrt(3.0) * sizing.C * sizing.Q;
}

class MovingMesh {
 public:
  /// @param sizing  what the growing mesh is kept to
  MovingMesh(const SkinSurface& skin, const certify::Sizing& sizing)
      : skin_(skin), sizing_(sizing), level_(skin, 0) {}

  const SurfaceMesh& surface() const { return surface_; }
  SurfaceMesh& surface() { return surface_; }  ///< for others to follow and to add triangles
  const SkinSurface& skin() const { return skin_; }
  const LevelSet& level() const { return level_; }

  void set_time(double t) {
    if (t != now_) level_ = LevelSet(skin_, t);
    now_ = t;
  }
  double time() const { return now_; }

  /// The vertex at the time set; if it was made later than that, where it was made.
  const SurfacePoint& at(VertexId v) {
    Moving& moving = moving_[v];
    if (moving.clock != now_) move(moving);
    return moving.point;
  }
  const Point& position(VertexId v) { return at(v).position; }
  const Trajectory& path(VertexId v) const { return moving_[v].path; }
  /// A vertex at a point of the skin at the time set, which may be another vertex of this mesh.
  VertexId add_vertex(SurfacePoint p);

  /// Flips the edge if it is better so, by balls to rounding.
  bool flip_if_better(HalfEdgeId h);
  /// Deletes one end of the edge.
  bool contract(HalfEdgeId h);
  /// Puts the centre of the triangle's surface ball into the mesh, unless an edge to it would have
  /// a ratio to [L] below `min_L`.
  bool insert(TriangleId t, double min_L);

  /// Takes out a triangle that these operations have changed, the last one first; nothing if there
  /// is none left. Each stands there once.
  std::optional<TriangleId> take_changed();
  std::size_t changed_count() const { return changed_.size(); }
  void add_changed(TriangleId t);

  /// How many ids of removed vertices are unused.
  std::size_t dead_count() const { return dead_; }
  /// The special sampling's spacing over the length scale.
  double spacing() const { return template_share * longest_edge(sizing_); }
  /// Takes triangles out, and with them the vertices that have no others.
  void remove(const std::vector<TriangleId>& triangles);
  /// Drops what has been removed. @pre nothing is changed
  void compact();
  /// What is there at the time set.
  surface::Mesh snapshot();

  refine::RefinementCounts counts;

 private:
  /// A vertex, in one piece of memory.
  struct Moving {
    SurfacePoint point{Point::Zero(), Vector::Zero(), 0, CellId{}};
    double clock = 0;  ///< the time at which it was at `point`
    Trajectory path;
  };

  void move(Moving& moving);
  auto points() {
    return [this](VertexId v) -> const SurfacePoint& { return at(v); };
  }
  void note_flip(HalfEdgeId h);
  bool remove(VertexId v);
  certify::SurfaceBall exact_ball(VertexId a, VertexId b, VertexId c) {
    return certify::exact_surface_ball(level_, at(a), position(b), position(c));
  }

  const SkinSurface& skin_;
  const certify::Sizing sizing_;
  LevelSet level_;
  double now_ = 0;
  SurfaceMesh surface_;
  geometry::VertexData<Moving> moving_{surface_};
  std::vector<TriangleId> changed_;
  geometry::TriangleData<char> is_changed_{surface_, 0};
  std::size_t dead_ = 0;

  refine::VertexRemoval removal_;
};

}  // namespace morskin::baselines
