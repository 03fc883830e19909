// The part of DelaunayRefinement that visits the triangulation as a whole: the facets that are
// left, all crossings of their dual edges, and whether they make a surface.

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/glued_triangles.h"
#include "refine/delaunay_refinement.h"

namespace morskin::refine {

using geometry::Triangulator;

/// Breaks facets of which something else was found than their balls' size, as long as they stand.
void DelaunayRefinement::break_all(const std::vector<Found>& found) {
  for (const Found& one : found) {
    if (!is_endless()) break_facet(one.work, one.ball);
  }
}

/// Checks all crossings of the dual edges that are new since the last time.
/// @return whether a surface ball was found that is too big
bool DelaunayRefinement::follow_dual_edges() {
  std::vector<Found> found;
  for (std::uint32_t t = 0; t < duals_.size(); ++t) {
    if (!delaunay_.is_live(t) || is_ghost(t)) continue;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const Facet f = t << 2 | k;
      const std::uint32_t other = Triangulator::tetrahedron_of(behind(f));
      if (other < t && !is_ghost(other)) continue;
      if (std::max(duals_[t].born, duals_[other].born) <= followed_) continue;
      follow(is_inside(other) ? behind(f) : f, found);
    }
  }
  followed_ = now_;
  counts_.hidden_crossings += found.size();
  break_all(found);
  return !found.empty();
}

/// Finds the crossings of a facet's dual edge whose balls are too big. Bounds spare most dual edges
/// the walk.
/// @param f  seen from inside where only one of its tetrahedra is
void DelaunayRefinement::follow(Facet f, std::vector<Found>& found) const {
  const std::uint32_t t = Triangulator::tetrahedron_of(f);
  const std::uint32_t u = Triangulator::tetrahedron_of(behind(f));
  const Dual &from = duals_[t], &to = duals_[u];
  const bool is_restricted = is_inside(t) != is_inside(u);
  if (!is_ghost(u) && !is_restricted &&
      surface::is_certainly_clear((from.centre - to.centre).norm(), std::abs(from.root),
                                  std::abs(to.root))) {
    return;
  }
  const FacetGeometry facet = geometry_of(f);
  // The dual edge over the facet, cut off where it leaves the ball that contains the body.
  const auto chord = body_.chord(facet.circle.centre, facet.normal);
  if (!chord) return;
  const double low = std::max(chord->low, facet.height(from.centre));
  const double high = is_ghost(u) ? chord->high : std::min(chord->high, facet.height(to.centre));
  if (!(low < high)) return;
  if (is_restricted) {
    const double root = is_ghost(u) || high == chord->high ? 0 : to.root;
    const std::optional<Ball> ball = ball_of(f, facet, false);
    if (ball && surface::is_certainly_clear_beyond(ball->height - low, ball->slope, -from.root) &&
        surface::is_certainly_clear_beyond(high - ball->height, ball->slope, root)) {
      return;
    }
  }
  const Point p = facet.circle.centre + low * facet.normal;
  const Point q = facet.circle.centre + high * facet.normal;
  for (const surface::LineCrossing& crossing : surface_.crossings(p, q, from.cell).all) {
    const Ball ball = ball_at(facet, low + crossing.at * (high - low), crossing.cell, 0);
    if (ball.ratio >= 1) found.push_back({work_on(f), ball});
  }
}

/// The facets between an inside and an outside tetrahedron, from the inside.
std::vector<DelaunayRefinement::Facet> DelaunayRefinement::restricted_facets() const {
  std::vector<Facet> facets;
  for (std::uint32_t t = 0; t < duals_.size(); ++t) {
    if (!delaunay_.is_live(t) || !is_inside(t)) continue;
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (!is_inside(Triangulator::tetrahedron_of(behind(t << 2 | k))))
        facets.push_back(t << 2 | k);
    }
  }
  return facets;
}

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The triangles with their corners numbered anew, in the order in which they come.
struct Numbered {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> corners;  ///< by new number, the old one
};
Numbered numbered(const std::vector<Triangle>& triangles, std::size_t corner_count) {
  Numbered result{triangles, {}};
  std::vector<std::uint32_t> number(corner_count, geometry::no_index);
  for (Triangle& t : result.triangles) {
    for (std::uint32_t& corner : t) {
      if (number[corner] == geometry::no_index) {
        number[corner] = static_cast<std::uint32_t>(result.corners.size());
        result.corners.push_back(corner);
      }
      corner = number[corner];
    }
  }
  return result;
}

/// The triangles in the order in which they are met going over edges, so that what is near in the
/// mesh is near in memory.
std::vector<Triangle> neighbours_together(const std::vector<Triangle>& triangles,
                                          const geometry::GluedTriangles& glued) {
  std::vector<Triangle> ordered;
  std::vector<std::uint32_t> order;
  std::vector<char> is_taken(triangles.size(), 0);
  const auto take = [&](TriangleId t) {
    if (std::exchange(is_taken[t.index()], 1) == 0) order.push_back(t.value);
  };
  for (std::uint32_t first = 0; first < triangles.size(); ++first) {
    const std::size_t before = order.size();
    take(TriangleId{first});
    for (std::size_t i = before; i < order.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        take(SurfaceMesh::triangle(glued.twin(SurfaceMesh::half_edge(TriangleId{order[i]}, k))));
      }
    }
  }
  for (const std::uint32_t t : order) ordered.push_back(triangles[t]);
  return ordered;
}

/// An edge of a triangle, seen from one of its ends.
struct Spoke {
  std::uint32_t corner, other, triangle;
  auto operator<=>(const Spoke&) const = default;
};

/// All, those of one corner together, and among them those of one edge.
std::vector<Spoke> sorted_spokes(const std::vector<Triangle>& triangles) {
  std::vector<Spoke> spokes;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      spokes.push_back({triangles[t][k], triangles[t][(k + 1) % 3], t});
      spokes.push_back({triangles[t][k], triangles[t][(k + 2) % 3], t});
    }
  }
  std::sort(spokes.begin(), spokes.end());
  return spokes;
}

/// Whether the triangles at a corner make one disk: each edge has two of them, and going round from
/// edge to edge comes by all. Each triangle has two spokes here, so their number is even.
bool is_disk(std::span<const Spoke> spokes) {
  for (std::size_t i = 0; i < spokes.size(); i += 2) {
    const bool is_pair = spokes[i].other == spokes[i + 1].other &&
                         (i + 2 == spokes.size() || spokes[i + 2].other != spokes[i].other);
    if (!is_pair) return false;
  }
  std::size_t at = 0, turns = 0;
  do {
    const std::size_t on_other_side = at ^ 1;
    ++turns;
    // The other spoke of that triangle.
    std::size_t next = 0;
    while (next == on_other_side || spokes[next].triangle != spokes[on_other_side].triangle) ++next;
    at = next;
  } while (at != 0 && turns <= spokes.size());
  return 2 * turns == spokes.size();
}

/// The corners where triangles do not make one disk: ends of edges with more than two triangles,
/// and corners whose triangles fall into several fans.
std::vector<std::uint32_t> corners_without_disk(const std::vector<Triangle>& triangles) {
  const std::vector<Spoke> spokes = sorted_spokes(triangles);
  std::vector<std::uint32_t> bad;
  for (std::size_t begin = 0, end = 0; begin < spokes.size(); begin = end) {
    while (end < spokes.size() && spokes[end].corner == spokes[begin].corner) ++end;
    if (!is_disk(std::span(spokes).subspan(begin, end - begin))) {
      bad.push_back(spokes[begin].corner);
    }
  }
  return bad;
}

}  // namespace

/// At each sample whose facets do not make a disk the largest surface ball is broken, whatever its
/// size: the sample is too coarse there to show the skin's topology.
/// @return whether there was one
bool DelaunayRefinement::make_disks() {
  const std::vector<Facet> facets = restricted_facets();
  std::vector<Triangle> triangles;
  for (const Facet f : facets) triangles.push_back(triangle(f));
  const Numbered compact = numbered(triangles, samples_.size());
  if (!geometry::closed_triangles(compact.corners.size(), compact.triangles).defect) return false;
  const std::vector<std::uint32_t> bad = corners_without_disk(triangles);
  if (counts_.topological + bad.size() > samples_.size()) return false;
  std::vector<Found> largest(bad.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const std::uint32_t corner : triangles[i]) {
      const auto found = std::lower_bound(bad.begin(), bad.end(), corner);
      if (found == bad.end() || *found != corner) continue;
      const std::optional<Ball> ball = ball_of(facets[i], geometry_of(facets[i]), true);
      Found& known = largest[static_cast<std::size_t>(found - bad.begin())];
      if (ball && ball->ratio > known.ball.ratio) known = {work_on(facets[i]), *ball};
    }
  }
  std::erase_if(largest, [](const Found& one) { return !(one.ball.ratio > 0); });
  counts_.topological += bad.size();
  break_all(largest);
  return !bad.empty();
}

Mesh DelaunayRefinement::mesh() const {
  std::vector<Triangle> triangles;
  for (const Facet f : restricted_facets()) triangles.push_back(triangle(f));
  Numbered compact = numbered(triangles, samples_.size());
  const auto built = geometry::closed_triangles(compact.corners.size(), compact.triangles);
  SurfaceMesh connectivity(compact.corners.size(), compact.triangles);
  std::vector<std::uint32_t> corners = compact.corners;
  if (!built.defect) {
    compact = numbered(neighbours_together(compact.triangles, built.mesh), corners.size());
    connectivity = geometry::closed_mesh(corners.size(), compact.triangles).mesh;
    for (std::uint32_t& corner : compact.corners) corner = corners[corner];
    corners = std::move(compact.corners);
  }
  Mesh mesh(std::move(connectivity));
  for (std::size_t v = 0; v < corners.size(); ++v) mesh.points[VertexId{v}] = samples_[corners[v]];
  return mesh;
}

}  // namespace morskin::refine
