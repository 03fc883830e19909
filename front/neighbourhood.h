#pragma once

/// The collision guard: the front near a departure vertex, seen in its tangent plane
/// (papers/4.1-algorithm.md, "The collision guard").

#include <optional>
#include <vector>

#include "front/front.h"
#include "geometry/orthogonal.h"

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

class Neighbourhood : public FrontMirror {
 public:
  Neighbourhood(const Mesh& mesh, const Front& front) : mesh_(mesh), front_(front) {}

  const Front& front() const { return front_; }

  /// Moves to a point of the skin and gathers every front corner within the grid's radius of its
  /// length scale, with the edges on both sides of each.
  void gather(const SurfacePoint& centre);
  /// The same in steps: first none are gathered, then some.
  void move_to(const SurfacePoint& centre);
  void add(FrontEdgeId e);
  bool is_within_radius(FrontEdgeId corner) const {
    return (front_[corner].position - origin_).squaredNorm() <= radius_ * radius_;
  }

  LocalPoint local(const Point& x) const {
    const Vector d = x - origin_;
    return {Vector2(tangent_.first.dot(d), tangent_.second.dot(d)), normal_.dot(d)};
  }
  /// The vector of the tangent plane with these coordinates, and the point.
  Vector in_tangent_plane(const Vector2& v) const {
    return v.x() * tangent_.first + v.y() * tangent_.second;
  }
  Point in_space(const Vector2& v) const { return origin_ + in_tangent_plane(v); }

  /// Whether every front corner in a ball has been gathered.
  bool is_in_view(const Point& centre, double radius) const {
    return radius <= radius_ &&
           (centre - origin_).squaredNorm() <= (radius_ - radius) * (radius_ - radius);
  }
  /// Whether no front corner in view lies within a distance of the centre.
  bool is_bare_within(double distance) const;

  /// Sees the front as it is after a change.
  void follow(const FrontChange& change) override;

  /// Counter-clockwise angle, in [0, 2 pi), that is bare at a corner: from the edge before round to
  /// the edge itself. An overlap of less than 0.3 counts as no angle at all.
  double bare_angle(FrontEdgeId corner) const;

  /// Whether the bare angle at a corner is below the (acute) angle with this cosine, without an arc
  /// tangent. An angle that laps over a little is.
  bool is_acute(FrontEdgeId corner, double cosine) const;

  // The guard's five conditions on a new vertex x as the apex over front edge e, pw.

  /// 1. The triangle is no flatter than a twentieth of the edge, and on the edge's bare side.
  bool is_high(FrontEdgeId e, const LocalPoint& x) const;
  /// 2. No front vertex but p and w lies within `vertex_gap` of x in space, and no front edge but
  /// pw within `edge_gap` in the plane, Angstrom.
  bool keeps_distance(FrontEdgeId e, const LocalPoint& x, double vertex_gap, double edge_gap) const;
  /// 3. No front vertex that both p and w see lies in the circle of p, w, x.
  bool has_empty_circle(FrontEdgeId e, const LocalPoint& x) const;
  /// 4. The sides px and wx cross no front edge.
  bool crosses_no_edge(FrontEdgeId e, const LocalPoint& x) const;
  /// 5. x lies in no finished triangle behind a front edge. A hole that is nearly flat may be
  /// inside out by the rounding of its vertices: its bare side is then where the mesh is.
  bool is_uncovered(FrontEdgeId e, const LocalPoint& x) const;

  /// All five at once, in one pass over the corners: what the sweep asks.
  bool is_clear(FrontEdgeId e, const LocalPoint& x, double vertex_gap, double edge_gap) const;

  /// The corner of the front that makes the Delaunay triangle over edge e: among the vertices seen
  /// from both its ends, the one whose circle is empty. Nothing if none is seen.
  std::optional<FrontEdgeId> delaunay_apex(FrontEdgeId e) const;

  /// Whether the triangle of edge e and a corner's vertex lies on bare surface: the sides meet no
  /// front edge and leave both vertices, and reach the third, through their bare sectors.
  bool sees(FrontEdgeId e, FrontEdgeId corner) const;

 private:
  struct Corner {
    FrontEdgeId edge;
    VertexId vertex, target;
    bool is_open;
    LocalPoint at;  ///< the corner's vertex
    Vector2 to;     ///< the target of the edge
  };
  /// Calls `holds` for every gathered open edge but e, until one does not.
  template <class Holds>
  bool holds_for_all_but(FrontEdgeId e, Holds holds) const;
  /// Whether the open segment from vertex a to vertex b crosses a front edge.
  bool is_crossed(VertexId a, const Vector2& at_a, VertexId b, const Vector2& at_b) const;
  /// Whether the direction d points into the bare sector of a corner.
  bool opens_towards(FrontEdgeId corner, const Vector2& at, const Vector2& d) const;
  /// Whether x lies in the finished triangle behind a front edge. @pre it is not on the bare side.
  bool covers(const Corner& c, const Vector2& x) const;
  void refresh(FrontEdgeId e);
  void forget(FrontEdgeId e);
  void update(FrontEdgeId e, Corner& corner) const;
  Vector2 plane(const FrontEdge& edge) const {
    const Vector d = edge.position - origin_;
    return {tangent_.first.dot(d), tangent_.second.dot(d)};
  }

  const Mesh& mesh_;
  const Front& front_;
  Point origin_ = Point::Zero();
  double radius_ = 0;
  Vector normal_ = Vector::UnitZ();
  geometry::TangentFrame tangent_{normal_};
  std::vector<Corner> corners_;
  geometry::IdVector<FrontEdgeId, std::uint32_t> index_;  ///< in corners_, checked on use
};

}  // namespace morskin::front
