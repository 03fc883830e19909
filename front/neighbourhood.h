#pragma once

/// The collision guard: what lies near a departure vertex, seen in its tangent plane.
///
/// The skin keeps a ball of radius rho free on both sides of every point
/// (papers/2.1-molecular-skin.md), so no other sheet comes within reach: the neighbourhood is one
/// disk of surface, nearly flat, and whether a new triangle would meet the front is a question in
/// the plane. The paper looks for collisions only inside protecting spheres; fronts meet elsewhere
/// as well (papers/4.1-algorithm.md).

#include <optional>
#include <vector>

#include "front/front.h"

namespace morskin::front {

using Vector2 = Eigen::Vector2d;

/// z component of a x b: positive when b is counter-clockwise of a.
inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A point near the departure vertex, in its frame: two coordinates in the tangent plane and the
/// height above it.
struct LocalPoint {
  Vector2 plane;
  double height;

  double squared_distance(const LocalPoint& other) const {
    const double h = height - other.height;
    return (plane - other.plane).squaredNorm() + h * h;
  }
};

class Neighbourhood {
 public:
  Neighbourhood(const Mesh& mesh, const Front& front) : mesh_(mesh), front_(front) {}

  /// Looks round a point of the skin: every front corner within the grid's reach of its length
  /// scale, and the edges on both sides of each.
  void gather(const SurfacePoint& centre);

  /// Looks along the polygon only: at a corner, the one before and the one after, and, if `far`, on
  /// both ways as far as the grid's reach.
  void gather_along(const SurfacePoint& centre, FrontEdgeId corner, bool far);

  LocalPoint local(const Point& x) const {
    const Vector d = x - origin_;
    return {Vector2(first_axis_.dot(d), second_axis_.dot(d)), normal_.dot(d)};
  }
  /// The vector of the tangent plane with these coordinates, and the point.
  Vector in_tangent_plane(const Vector2& v) const {
    return v.x() * first_axis_ + v.y() * second_axis_;
  }
  Point in_space(const Vector2& v) const { return origin_ + in_tangent_plane(v); }

  /// Whether every front corner in a ball has been gathered.
  bool is_in_view(const Point& centre, double radius) const {
    return radius <= reach_ &&
           (centre - origin_).squaredNorm() <= (reach_ - radius) * (reach_ - radius);
  }

  /// Notes that a front edge is new or has new ends.
  void refresh(FrontEdgeId e);
  /// Drops edges that are no longer open.
  void forget(FrontEdgeId e);

  /// Counter-clockwise angle, in [0, 2 pi), that is bare at a corner: from the edge before round to
  /// the edge itself. An overlap of less than `least_fan_angle` counts as no angle at all.
  double bare_angle(FrontEdgeId corner) const;

  /// Whether the bare angle at a corner is below the (acute) angle with this cosine, without an arc
  /// tangent. An angle that laps over a little is.
  bool is_acute(FrontEdgeId corner, double cosine) const;

  /// Whether a new vertex x would do as the apex over edge e: not within `vertex_gap` of a front
  /// vertex nor within `edge_gap` of a front edge (Angstrom), no front vertex in the disk round the
  /// triangle, no front edge across the triangle's new sides, and not in a finished triangle behind
  /// the front: a hole that is nearly flat may be inside out by rounding of its vertices' places,
  /// and then its bare side is where the mesh is.
  bool is_clear(FrontEdgeId e, const LocalPoint& x, double vertex_gap, double edge_gap) const;

  /// The corner of the front that makes the Delaunay triangle over edge e: among the vertices seen
  /// from both its ends, the one whose circle is empty. Nothing if none is seen.
  std::optional<FrontEdgeId> delaunay_apex(FrontEdgeId e) const;

  /// Whether the triangle of edge e and a corner's vertex lies on bare surface: the sides meet no
  /// front edge and leave both vertices, and reach the third, through their bare sectors.
  bool sees(FrontEdgeId e, FrontEdgeId corner) const;

 private:
  void stand_at(const SurfacePoint& centre);
  struct Corner {
    FrontEdgeId edge;
    VertexId vertex, target;
    bool is_open;
    LocalPoint at;  ///< the corner's vertex
    Vector2 to;     ///< the target of the edge
  };
  /// Whether the open segment from vertex a to vertex b crosses a front edge.
  bool is_crossed(VertexId a, const Vector2& at_a, VertexId b, const Vector2& at_b) const;
  /// Whether the direction d points into the bare sector of a corner.
  bool opens_towards(FrontEdgeId corner, const Vector2& at, const Vector2& d) const;
  /// Whether x lies in the finished triangle behind a front edge. @pre it is not on the bare side.
  bool covers(const Corner& c, const Vector2& x) const;
  void list(FrontEdgeId e);
  void look_at(FrontEdgeId e, Corner& corner) const;
  Vector2 plane(const FrontEdge& edge) const {
    const Vector d = edge.position - origin_;
    return {first_axis_.dot(d), second_axis_.dot(d)};
  }

  const Mesh& mesh_;
  const Front& front_;
  Point origin_ = Point::Zero();
  double reach_ = 0;
  Vector normal_ = Vector::Zero(), first_axis_ = Vector::Zero(), second_axis_ = Vector::Zero();
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> place_;  ///< by front edge: its place in corners_, checked on use
};

}  // namespace morskin::front
