#pragma once

/// Moves one vertex of a mesh along the skin to bring the angles of the triangles around it nearer
/// to a goal: what smoothing does (smoothing.h), and all it asks of a position before a vertex goes
/// there.

#include <optional>
#include <utility>
#include <vector>

#include "refine/angle_goal.h"

namespace morskin::refine {

class VertexMover {
 public:
  /// @param subdomain  whose vertices it may move
  VertexMover(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
              const AngleGoal& goal, const Subdomain& subdomain)
      : surface_(surface), sizing_(sizing), mesh_(mesh), goal_(goal), subdomain_(subdomain) {}

  enum class Moved { Yes, No, NotMine };
  /// Moves v by ever smaller steps, as long as its worst triangle gets better and is not good
  /// enough.
  Moved move(VertexId v);
  /// Moves v to the mean of its neighbours, those counting more that are far away for their length
  /// scales, if [L] and [U] hold there and triangles face outward; whatever the goal. Balls may be
  /// left with a vertex inside.
  /// @return whether it moved
  bool even_out(VertexId v);

 private:
  bool gather_neighbours(VertexId v);
  double quality(const Point& x, double asked) const;
  bool keeps_size(const SurfacePoint& x) const;
  bool keeps_provable(const SurfacePoint& x) const;
  bool keeps_delaunay(const SurfacePoint& x) const;
  std::optional<std::pair<double, SurfacePoint>> step_from(const SurfacePoint& x, double step,
                                                           double asked) const;

  const surface::Surface& surface_;
  const Sizing sizing_;
  Mesh& mesh_;
  const AngleGoal goal_;
  const Subdomain subdomain_;
  std::vector<VertexId> ring_, beyond_;  ///< of gather_neighbours()
};

}  // namespace morskin::refine
