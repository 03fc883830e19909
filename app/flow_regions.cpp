#include "app/flow_regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "geometry/glued_triangles.h"
#include "geometry/parallel.h"
#include "geometry/sort_unique.h"

namespace morskin::app {
namespace {

using geometry::HalfEdgeId;
using geometry::Point;
using geometry::SurfaceMesh;
using geometry::TriangleId;
using geometry::Vector;
using geometry::VertexId;

using geometry::no_index;

// Walks up a function that is linear on every triangle.
//
// Inside a triangle a path is straight, so each barycentric coordinate changes at a constant rate.
// Barycentric coordinates and rates are by half-edge: that of the opposite corner, zero on it.
class Ascent {
 public:
  Ascent(const SurfaceMesh& mesh, const std::vector<Point>& positions,
         const std::vector<double>& values)
      : mesh_(mesh),
        positions_(positions),
        values_(values),
        top_(positions.size(), no_index),
        top_of_triangle_(mesh.triangle_count(), no_index) {
    rates_.reserve(mesh.triangle_count());
    slope_.reserve(mesh.triangle_count());
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId{t});
      const Vector ab = position(b) - position(a), bc = position(c) - position(b),
                   ca = position(a) - position(c);
      const Vector normal = ab.cross(bc);
      Coordinates rates{};
      double slope = 0;
      if (normal.squaredNorm() > 0) {
        const std::array<Vector, 3> rise{normal.cross(ab), normal.cross(bc), normal.cross(ca)};
        const Vector gradient =
            (value(c) * rise[0] + value(a) * rise[1] + value(b) * rise[2]) / normal.squaredNorm();
        for (std::size_t k = 0; k < 3; ++k) rates[k] = gradient.dot(rise[k]) / normal.squaredNorm();
        slope = gradient.norm();
      }
      rates_.push_back(rates);
      slope_.push_back(slope);
    }
  }

  // By triangle the vertex where the path from its centroid ends: a local maximum.
  const std::vector<std::uint32_t>& tops() {
    // From above, so that paths soon enter triangles with known ends.
    std::vector<std::pair<double, std::uint32_t>> order;
    order.reserve(top_of_triangle_.size());
    for (std::uint32_t t = 0; t < top_of_triangle_.size(); ++t) {
      const auto [a, b, c] = mesh_.corners(TriangleId{t});
      order.emplace_back(-(value(a) + value(b) + value(c)), t);
    }
    std::ranges::sort(order);
    for (const auto& [unused, t] : order) {
      top_of_triangle_[t] = follow(TriangleId{t}, {1.0 / 3, 1.0 / 3, 1.0 / 3}).value;
    }
    return top_of_triangle_;
  }

 private:
  using Coordinates = std::array<double, 3>;

  const Point& position(VertexId v) const { return positions_[v.index()]; }
  double value(VertexId v) const { return values_[v.index()]; }
  double rate(HalfEdgeId h) const { return rates_[h.index() / 3][h.index() % 3]; }
  VertexId higher_end(HalfEdgeId h) const {
    const VertexId a = mesh_.origin(h), b = mesh_.target(h);
    return value(a) > value(b) ? a : b;
  }

  // Whether the paths from a triangle and its neighbours all end at one vertex: then so does every
  // path through it.
  bool is_settled(TriangleId t) const {
    const std::uint32_t top = top_of_triangle_[t.index()];
    if (top == no_index) return false;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId beyond = mesh_.twin(SurfaceMesh::half_edge(t, k));
      if (top_of_triangle_[beyond.index() / 3] != top) return false;
    }
    return true;
  }

  // From a point in t.
  VertexId follow(TriangleId t, Coordinates at) {
    // Values grow along the path up to rounding; a path longer than this cycles in it.
    const std::size_t most = 1000 + 4 * mesh_.triangle_count();
    for (std::size_t i = 0; i < most; ++i) {
      const Coordinates& rates = rates_[t.index()];
      std::uint32_t exit = 3;
      double least = std::numeric_limits<double>::infinity();
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (!(rates[k] < 0)) continue;
        const double s = std::max(at[k], 0.0) / -rates[k];
        if (s < least) {
          least = s;
          exit = k;
        }
      }
      if (exit == 3) break;
      const HalfEdgeId h = SurfaceMesh::half_edge(t, exit), beyond = mesh_.twin(h);
      if (!(rate(beyond) > 0)) return top(higher_end(h));
      const std::size_t k1 = (exit + 1) % 3, k2 = (exit + 2) % 3;
      const double at_origin = at[k1] + least * rates[k1], at_target = at[k2] + least * rates[k2];
      const std::size_t m = beyond.index() % 3;
      at[m] = 0;
      at[(m + 1) % 3] = at_target;
      at[(m + 2) % 3] = at_origin;
      t = SurfaceMesh::triangle(beyond);
      if (is_settled(t)) return VertexId{top_of_triangle_[t.index()]};
    }
    const auto corners = mesh_.corners(t);
    return top(*std::ranges::max_element(corners, {}, [&](VertexId v) { return value(v); }));
  }

  // The vertex where the path from a vertex ends.
  VertexId top(VertexId v) {
    std::vector<VertexId> path;
    while (top_[v.index()] == no_index) {
      path.push_back(v);
      top_[v.index()] = v.value;  // until its end is known
      const std::optional<VertexId> up = step(v);
      if (!up) break;
      v = *up;
    }
    const std::uint32_t end = top_[v.index()];
    for (const VertexId w : path) top_[w.index()] = end;
    return VertexId{end};
  }

  // One step from a vertex, along the steepest of its edges and triangles; nothing at a top.
  // Follows a path through a triangle to its end.
  std::optional<VertexId> step(VertexId v) {
    double steepest = 0;
    HalfEdgeId best;
    bool is_edge = true;
    mesh_.for_each_outgoing(v, [&](HalfEdgeId h) {
      const VertexId w = mesh_.target(h);
      const double along = (value(w) - value(v)) / (position(w) - position(v)).norm();
      const double inside = slope_[SurfaceMesh::triangle(h).index()];
      if (along > steepest) {
        steepest = along;
        best = h;
        is_edge = true;
      }
      if (rate(h) > 0 && rate(SurfaceMesh::previous(h)) > 0 && inside > steepest) {
        steepest = inside;
        best = h;
        is_edge = false;
      }
    });
    if (!(steepest > 0)) return std::nullopt;
    if (is_edge) return mesh_.target(best);
    Coordinates at{};
    at[SurfaceMesh::next(best).index() % 3] = 1;
    return follow(SurfaceMesh::triangle(best), at);
  }

  const SurfaceMesh& mesh_;
  const std::vector<Point>& positions_;
  const std::vector<double>& values_;
  std::vector<Coordinates> rates_;  // by triangle
  std::vector<double> slope_;       // by triangle, the gradient's length
  std::vector<std::uint32_t> top_;  // by vertex, where its path ends, once known
  std::vector<std::uint32_t> top_of_triangle_;
};

std::uint32_t nearest_of(const std::vector<morse::CriticalPoint>& points, int index,
                         const Point& x) {
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t c = 0; c < points.size(); ++c) {
    if (points[c].index != index) continue;
    const double squared_distance = (points[c].point.position - x).squaredNorm();
    if (squared_distance < least) {
      least = squared_distance;
      nearest = c;
    }
  }
  return nearest;
}

// By triangle the extremum of an index at the end of its path.
std::vector<std::uint32_t> extrema(const SurfaceMesh& mesh, const geometry::IndexedMesh& indexed,
                                   const morse::MorseFunction& function, int index,
                                   const std::vector<morse::CriticalPoint>& points) {
  std::vector<double> values;
  values.reserve(indexed.positions.size());
  for (const Point& p : indexed.positions) values.push_back(function(p));
  Ascent ascent(mesh, indexed.positions, values);
  std::vector<std::uint32_t> nearest(indexed.positions.size(), no_index);  // by top
  std::vector<std::uint32_t> result;
  result.reserve(mesh.triangle_count());
  for (const std::uint32_t v : ascent.tops()) {
    if (nearest[v] == no_index) nearest[v] = nearest_of(points, index, indexed.positions[v]);
    result.push_back(nearest[v]);
  }
  return result;
}

// A sphere without saddles is one region, between an extremum of each kind that no arc ends at.
void add_whole_spheres(const morse::MorseSmaleComplex& complex, std::set<FlowRegion>& regions) {
  std::vector<bool> has_arc(complex.points.size(), false);
  for (const morse::Arc& arc : complex.arcs) has_arc[arc.extremum.index()] = true;
  for (std::uint32_t low = 0; low < complex.points.size(); ++low) {
    if (complex.points[low].index != 0 || has_arc[low]) continue;
    for (std::uint32_t high = 0; high < complex.points.size(); ++high) {
      if (complex.points[high].index == 2 && !has_arc[high]) regions.insert({low, high});
    }
  }
}

// Triangles whose pair belongs to no region take that of the nearest triangle, across edges, whose
// pair does.
void keep_to_regions(const SurfaceMesh& mesh, const std::set<FlowRegion>& regions,
                     std::vector<FlowRegion>& pairs) {
  std::vector<std::uint32_t> queue;
  std::vector<bool> is_known(pairs.size());
  for (std::uint32_t t = 0; t < pairs.size(); ++t) {
    is_known[t] = regions.contains(pairs[t]);
    if (is_known[t]) queue.push_back(t);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{queue[i]}, k);
      const std::uint32_t beyond = SurfaceMesh::triangle(mesh.twin(h)).value;
      if (is_known[beyond]) continue;
      is_known[beyond] = true;
      pairs[beyond] = pairs[queue[i]];
      queue.push_back(beyond);
    }
  }
}

}  // namespace

FlowRegions flow_regions(const geometry::IndexedMesh& mesh, const morse::MorseFunction& function,
                         const morse::MorseSmaleComplex& complex, const geometry::Run& run) {
  const SurfaceMesh surface = geometry::closed_mesh(mesh.positions.size(), mesh.triangles).mesh;
  std::vector<std::uint32_t> up, down;
  geometry::do_both(
      run.threads(), [&] { up = extrema(surface, mesh, function, 2, complex.points); },
      [&] { down = extrema(surface, mesh, function.reversed(), 0, complex.points); });
  std::vector<FlowRegion> pairs;
  pairs.reserve(up.size());
  for (std::size_t t = 0; t < up.size(); ++t) pairs.push_back({down[t], up[t]});
  if (!complex.regions.empty()) {
    std::set<FlowRegion> regions;
    for (const auto& [minimum, saddle, maximum, other] : complex.regions) {
      regions.insert({minimum.value, maximum.value});
    }
    add_whole_spheres(complex, regions);
    keep_to_regions(surface, regions, pairs);
  }
  FlowRegions result;
  result.regions = pairs;
  geometry::sort_unique(result.regions);
  result.of_triangle.reserve(pairs.size());
  for (const FlowRegion& pair : pairs) {
    const auto at = std::ranges::lower_bound(result.regions, pair);
    result.of_triangle.push_back(static_cast<std::uint32_t>(at - result.regions.begin()));
  }
  return result;
}

}  // namespace morskin::app
