#include "geometry/triangle_contact.h"

#include <algorithm>

#include "geometry/expansion.h"
#include "geometry/predicates.h"

namespace morskin::geometry {

namespace {

/// The two coordinates of a projection onto a coordinate plane.
struct Shadow {
  int i, j;
};

/// The orientation of p, q, r in a projection: the sign of (q - p) x (r - p).
Sign turn(const Point& p, const Point& q, const Point& r, Shadow s) {
  const double ax = q[s.i] - p[s.i], ay = q[s.j] - p[s.j];
  const double bx = r[s.i] - p[s.i], by = r[s.j] - p[s.j];
  const double value = ax * by - ay * bx;
  // Each product has 4 roundings (2 differences, itself, the sum), and one as a margin.
  if (std::fabs(value) > 5 * 0x1p-53 * (std::fabs(ax * by) + std::fabs(ay * bx))) {
    return sign_of(value);
  }
  const auto difference = [&](const Point& x, int k) { return Expansion::difference(x[k], p[k]); };
  return (difference(q, s.i) * difference(r, s.j) - difference(q, s.j) * difference(r, s.i)).sign();
}

using Triangle = std::array<const Point*, 3>;

/// A projection in which the triangle is not flat. @pre its corners are not on one line.
Shadow full_shadow(const Triangle& t) {
  for (const Shadow s : {Shadow{0, 1}, Shadow{1, 2}}) {
    if (turn(*t[0], *t[1], *t[2], s) != Sign::Zero) return s;
  }
  return {2, 0};
}

bool are_strictly_opposite(Sign a, Sign b) { return a != Sign::Zero && b != Sign::Zero && a != b; }

bool is_between(double x, double a, double b) { return std::min(a, b) <= x && x <= std::max(a, b); }

/// Whether the closed segments pq and ab meet in the projection.
bool segments_meet(const Point& p, const Point& q, const Point& a, const Point& b, Shadow s) {
  const Sign pa = turn(p, q, a, s), pb = turn(p, q, b, s);
  const Sign ap = turn(a, b, p, s), aq = turn(a, b, q, s);
  if (are_strictly_opposite(pa, pb) && are_strictly_opposite(ap, aq)) return true;
  const auto on_segment = [&](Sign side, const Point& x, const Point& c, const Point& d) {
    return side == Sign::Zero && is_between(x[s.i], c[s.i], d[s.i]) &&
           is_between(x[s.j], c[s.j], d[s.j]);
  };
  return on_segment(pa, a, p, q) || on_segment(pb, b, p, q) || on_segment(ap, p, a, b) ||
         on_segment(aq, q, a, b);
}

bool contains(const Triangle& t, const Point& x, Shadow s) {
  const Sign a = turn(*t[0], *t[1], x, s), b = turn(*t[1], *t[2], x, s),
             c = turn(*t[2], *t[0], x, s);
  return !are_strictly_opposite(a, b) && !are_strictly_opposite(b, c) &&
         !are_strictly_opposite(c, a);
}

/// Whether a segment in the triangle's plane meets it.
bool coplanar_segment_meets(const Point& p, const Point& q, const Triangle& t) {
  const Shadow s = full_shadow(t);
  return contains(t, p, s) || segments_meet(p, q, *t[0], *t[1], s) ||
         segments_meet(p, q, *t[1], *t[2], s) || segments_meet(p, q, *t[2], *t[0], s);
}

/// Whether the closed segment pq meets the closed triangle t, given the sides of its plane on which
/// p and q lie. A line across the plane meets the triangle unless two edges are on opposite sides
/// of it.
bool segment_meets(const Point& p, const Point& q, Sign p_side, Sign q_side, const Triangle& t) {
  if (p_side == q_side) return p_side == Sign::Zero && coplanar_segment_meets(p, q, t);
  const Sign a = orientation(p, q, *t[0], *t[1]);
  const Sign b = orientation(p, q, *t[1], *t[2]);
  if (are_strictly_opposite(a, b)) return false;
  const Sign c = orientation(p, q, *t[2], *t[0]);
  return !are_strictly_opposite(b, c) && !are_strictly_opposite(c, a);
}

Sign side(const Triangle& t, const Point& x) { return orientation(*t[0], *t[1], *t[2], x); }

/// Without a common corner: any contact counts, and exists exactly if an edge of one meets the
/// other.
bool meet_apart(const Triangle& s, const Triangle& t) {
  const std::array<Sign, 3> s_sides{side(t, *s[0]), side(t, *s[1]), side(t, *s[2])};
  const auto is_beside = [](const std::array<Sign, 3>& sides) {
    return sides[0] != Sign::Zero && sides[0] == sides[1] && sides[1] == sides[2];
  };
  if (is_beside(s_sides)) return false;
  const std::array<Sign, 3> t_sides{side(s, *t[0]), side(s, *t[1]), side(s, *t[2])};
  if (is_beside(t_sides)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (segment_meets(*s[k], *s[next], s_sides[k], s_sides[next], t)) return true;
    if (segment_meets(*t[k], *t[next], t_sides[k], t_sides[next], s)) return true;
  }
  // Coplanar with t inside s: t's edges met s above.
  return false;
}

/// With corner 0 in common. If they meet elsewhere they share, being convex, a segment from the
/// corner, which ends on the far edge of one of them.
bool meet_beyond_corner(const Triangle& s, const Triangle& t) {
  const Sign s1 = side(t, *s[1]), s2 = side(t, *s[2]);
  if (s1 != Sign::Zero && s1 == s2) return false;
  const Sign t1 = side(s, *t[1]), t2 = side(s, *t[2]);
  if (t1 != Sign::Zero && t1 == t2) return false;
  return segment_meets(*s[1], *s[2], s1, s2, t) || segment_meets(*t[1], *t[2], t1, t2, s);
}

/// With edge 0-1 in common: improper only if folded flat onto each other.
bool meet_beyond_edge(const Triangle& s, const Triangle& t) {
  if (side(s, *t[2]) != Sign::Zero) return false;
  const Shadow shadow = full_shadow(s);
  return turn(*s[0], *s[1], *s[2], shadow) == turn(*s[0], *s[1], *t[2], shadow);
}

}  // namespace

bool is_improper_contact(const ExactPositions& positions, const TriangleCorners& s,
                         const TriangleCorners& t) {
  // Common corners first, in the same order in both.
  Triangle a, b;
  std::array<bool, 3> is_taken{};
  std::size_t shared = 0, alone = 2;
  for (const std::uint32_t v : s) {
    std::size_t k = 0;
    while (k < 3 && t[k] != v) ++k;
    if (k == 3) {
      a[alone--] = &positions[v];
      continue;
    }
    is_taken[k] = true;
    a[shared] = b[shared] = &positions[v];
    ++shared;
  }
  std::size_t next = shared;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!is_taken[k]) b[next++] = &positions[t[k]];
  }
  switch (shared) {
    case 0:
      return meet_apart(a, b);
    case 1:
      return meet_beyond_corner(a, b);
    case 2:
      return meet_beyond_edge(a, b);
    default:
      return true;
  }
}

}  // namespace morskin::geometry
