// The collision guard: what the front allows, in the tangent plane of the departure vertex.

#include <algorithm>
#include <cmath>
#include <limits>

#include "front/neighbourhood.h"

namespace morskin::front {

namespace {

/// Whether the open segments ab and cd cross.
bool segments_cross(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const Vector2 ab = b - a, cd = d - c;
  return (cross(ab, c - a) > 0) != (cross(ab, d - a) > 0) &&
         (cross(cd, a - c) > 0) != (cross(cd, b - c) > 0);
}

/// Whether x is nearer than `gap` to the segment from c along cd. Most are farther from the whole
/// line, which takes no division to tell.
/// @param cx, side  x - c, and cd x cx
bool is_near_segment(const Vector2& cd, const Vector2& cx, double side, double gap) {
  const double squared_length = cd.squaredNorm();
  if (side * side >= gap * gap * squared_length) return false;
  const double along = std::clamp(cd.dot(cx) / squared_length, 0.0, 1.0);
  return (cx - along * cd).squaredNorm() < gap * gap;
}

/// The circles through the ends of an edge pw and a vertex on its right, compared by how far along
/// the edge's right-hand normal their centres lie: of two vertices the one with the smaller offset
/// lies in the other's circle.
class CirclesOver {
 public:
  CirclesOver(const Vector2& p, const Vector2& w)
      : middle_((p + w) / 2), edge_(w - p), squared_length_(edge_.squaredNorm()) {}

  /// The offset of v's circle, in units of the edge's length; nothing for a vertex not on the
  /// right.
  std::optional<double> offset(const Vector2& v) const {
    const Vector2 m = v - middle_;
    const double h = -cross(edge_, m);
    if (h < min_height * squared_length_) return std::nullopt;
    return (m.squaredNorm() - squared_length_ / 4) / (2 * h);
  }

  /// Whether v may have an offset below a bound: false for most that have not, without a division.
  bool may_be_below(const Vector2& v, double bound) const {
    constexpr double margin = 1e-9;  // far above rounding
    const Vector2 m = v - middle_;
    const double h = -cross(edge_, m), left = m.squaredNorm(), right = 2 * h * bound;
    return (h >= min_height * squared_length_) &
           (left - squared_length_ / 4 <=
            right + margin * (left + squared_length_ + std::abs(right)));
  }

 private:
  // Flatter than this the triangle is a sliver; such a vertex is reached over another edge.
  static constexpr double min_height = 0.05;
  Vector2 middle_, edge_;
  double squared_length_;
};

}  // namespace

bool Neighbourhood::is_crossed(VertexId a, const Vector2& at_a, VertexId b,
                               const Vector2& at_b) const {
  for (const Corner& c : corners_) {
    if (!c.is_open || c.vertex == a || c.vertex == b || c.target == a || c.target == b) continue;
    if (segments_cross(at_a, at_b, c.at.plane, c.to)) return true;
  }
  return false;
}

bool Neighbourhood::opens_towards(FrontEdgeId corner, const Vector2& at, const Vector2& d) const {
  const Vector2 out = plane(front_.next(corner)) - at, in = plane(front_.previous(corner)) - at;
  if (cross(in, out) >= 0) return cross(in, d) > 0 && cross(d, out) > 0;
  return !(cross(out, d) >= 0 && cross(d, in) >= 0);
}

bool Neighbourhood::covers(const Corner& c, const Vector2& x) const {
  const Vector2& a = c.at.plane;
  const Vector2 apex = local(mesh_.position(mesh_.surface.apex(front_[c.edge].half_edge))).plane;
  return cross(apex - c.to, x - c.to) >= 0 && cross(a - apex, x - apex) >= 0;
}

template <class Holds>
bool Neighbourhood::holds_for_all_but(FrontEdgeId e, Holds holds) const {
  return std::ranges::all_of(
      corners_, [&](const Corner& c) { return !c.is_open || c.edge == e || holds(c); });
}

bool Neighbourhood::is_high(FrontEdgeId e, const LocalPoint& x) const {
  return CirclesOver(plane(front_[e]), plane(front_.next(e))).offset(x.plane).has_value();
}

bool Neighbourhood::keeps_distance(FrontEdgeId e, const LocalPoint& x, double vertex_gap,
                                   double edge_gap) const {
  const VertexId p = front_[e].origin, w = front_.target(e);
  return holds_for_all_but(e, [&](const Corner& c) {
    const Vector2 along = c.to - c.at.plane, to_x = x.plane - c.at.plane;
    const bool is_end = c.vertex == p || c.vertex == w;
    return (is_end || c.at.squared_distance(x) >= vertex_gap * vertex_gap) &&
           !is_near_segment(along, to_x, cross(along, to_x), edge_gap);
  });
}

bool Neighbourhood::has_empty_circle(FrontEdgeId e, const LocalPoint& x) const {
  const VertexId p = front_[e].origin, w = front_.target(e);
  const CirclesOver circles(plane(front_[e]), plane(front_.next(e)));
  const auto offset = circles.offset(x.plane);
  return holds_for_all_but(e, [&](const Corner& c) {
    if (!offset || c.vertex == p || c.vertex == w) return true;
    const auto other = circles.offset(c.at.plane);
    return !other || *other >= *offset || !sees(e, c.edge);
  });
}

bool Neighbourhood::crosses_no_edge(FrontEdgeId e, const LocalPoint& x) const {
  const VertexId p = front_[e].origin, w = front_.target(e);
  const Vector2 at_p = plane(front_[e]), at_w = plane(front_.next(e));
  return holds_for_all_but(e, [&](const Corner& c) {
    const auto crosses = [&](VertexId end, const Vector2& at) {
      return c.vertex != end && c.target != end && segments_cross(at, x.plane, c.at.plane, c.to);
    };
    return !crosses(p, at_p) && !crosses(w, at_w);
  });
}

bool Neighbourhood::is_uncovered(FrontEdgeId e, const LocalPoint& x) const {
  return holds_for_all_but(e, [&](const Corner& c) {
    const bool is_behind = cross(c.to - c.at.plane, x.plane - c.at.plane) > 0;
    return !is_behind || !covers(c, x.plane);
  });
}

bool Neighbourhood::is_clear(FrontEdgeId e, const LocalPoint& x, double vertex_gap,
                             double edge_gap) const {
  const VertexId p = front_[e].origin, w = front_.target(e);
  const Vector2 at_p = plane(front_[e]), at_w = plane(front_.next(e));
  const CirclesOver circles(at_p, at_w);
  const auto offset = circles.offset(x.plane);
  if (!offset) return false;
  for (const Corner& c : corners_) {
    if (!c.is_open || c.edge == e) continue;
    if (c.vertex != p && c.vertex != w) {
      if (c.at.squared_distance(x) < vertex_gap * vertex_gap) return false;
      if (circles.may_be_below(c.at.plane, *offset)) {
        const auto other = circles.offset(c.at.plane);
        if (other && *other < *offset && sees(e, c.edge)) return false;
      }
    }
    // On which side of the front edge x lies answers the rest, but for few edges.
    const Vector2 along = c.to - c.at.plane, to_x = x.plane - c.at.plane;
    const double side = cross(along, to_x);
    if (is_near_segment(along, to_x, side, edge_gap)) return false;
    if (side > 0 && covers(c, x.plane)) return false;
    const auto crosses = [&](VertexId end, const Vector2& at) {
      const bool is_joined = c.vertex == end || c.target == end;
      return !is_joined && (cross(along, at - c.at.plane) > 0) != (side > 0) &&
             segments_cross(at, x.plane, c.at.plane, c.to);
    };
    if (crosses(p, at_p) || crosses(w, at_w)) return false;
  }
  return true;
}

bool Neighbourhood::sees(FrontEdgeId e, FrontEdgeId corner) const {
  const VertexId p = front_[e].origin, w = front_.target(e), v = front_[corner].origin;
  const Vector2 at_p = plane(front_[e]), at_w = plane(front_.next(e)), at_v = plane(front_[corner]);
  const FrontEdgeId after = front_[e].next;
  const bool is_before = corner == front_[e].previous, is_after = front_[corner].previous == after;
  if (!is_before &&
      (!opens_towards(e, at_p, at_v - at_p) || !opens_towards(corner, at_v, at_p - at_v))) {
    return false;
  }
  if (!is_after &&
      (!opens_towards(after, at_w, at_v - at_w) || !opens_towards(corner, at_v, at_w - at_v))) {
    return false;
  }
  return (is_before || !is_crossed(p, at_p, v, at_v)) &&
         (is_after || !is_crossed(w, at_w, v, at_v));
}

std::optional<FrontEdgeId> Neighbourhood::delaunay_apex(FrontEdgeId e) const {
  const VertexId p = front_[e].origin, w = front_.target(e);
  const CirclesOver circles(plane(front_[e]), plane(front_.next(e)));
  std::optional<FrontEdgeId> best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](FrontEdgeId corner, const Vector2& at) {
    const auto offset = circles.offset(at);
    if (!offset || *offset >= least || !sees(e, corner)) return;
    least = *offset;
    best = corner;
  };
  // Mostly it is the vertex before the edge; known first, it spares the others the full test.
  const FrontEdgeId before = front_[e].previous;
  consider(before, plane(front_[before]));
  for (const Corner& c : corners_) {
    if (c.is_open && c.vertex != p && c.vertex != w && circles.may_be_below(c.at.plane, least)) {
      consider(c.edge, c.at.plane);
    }
  }
  return best;
}

}  // namespace morskin::front
