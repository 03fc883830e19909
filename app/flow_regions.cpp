#include "app/flow_regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/parallel.h"
#include "geometry/surface_mesh.h"

namespace morskin::app {
namespace {

using geometry::HalfEdgeId;
using geometry::Point;
using geometry::SurfaceMesh;
using geometry::TriangleId;
using geometry::Vector;
using geometry::VertexId;

constexpr std::uint32_t none = 0xFFFFFFFFU;

// Walks up a function that is linear on every triangle.
//
// Inside a triangle a path is straight, so each barycentric coordinate changes at a constant rate.
// Coordinates and rates are told by half-edge: that of the corner opposite, which is zero on it.
class Ascent {
 public:
  Ascent(const SurfaceMesh& mesh, const std::vector<Point>& positions,
         const std::vector<double>& values)
      : mesh_(mesh), positions_(positions), values_(values), top_(positions.size(), none) {
    rates_.reserve(mesh.triangle_count());
    slope_.reserve(mesh.triangle_count());
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId{t});
      const Vector ab = place(b) - place(a), bc = place(c) - place(b), ca = place(a) - place(c);
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

  // The vertex where the path from the middle of a triangle ends: one that nothing near is above.
  VertexId top_from(TriangleId t) { return follow(t, {1.0 / 3, 1.0 / 3, 1.0 / 3}); }

 private:
  using Coordinates = std::array<double, 3>;

  const Point& place(VertexId v) const { return positions_[v.index()]; }
  double value(VertexId v) const { return values_[v.index()]; }
  double rate(HalfEdgeId h) const { return rates_[h.index() / 3][h.index() % 3]; }
  VertexId higher_end(HalfEdgeId h) const {
    const VertexId a = mesh_.origin(h), b = mesh_.target(h);
    return value(a) > value(b) ? a : b;
  }

  // From a place in t.
  VertexId follow(TriangleId t, Coordinates at) {
    // Values grow along the path, but for rounding; a path longer than this goes round in it.
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
    }
    const auto corners = mesh_.corners(t);
    return top(*std::ranges::max_element(corners, {}, [&](VertexId v) { return value(v); }));
  }

  // The vertex where the path from a vertex ends.
  VertexId top(VertexId v) {
    std::vector<VertexId> way;
    while (top_[v.index()] == none) {
      way.push_back(v);
      top_[v.index()] = v.value;  // until more is known
      const std::optional<VertexId> up = step(v);
      if (!up) break;
      v = *up;
    }
    const std::uint32_t end = top_[v.index()];
    for (const VertexId w : way) top_[w.index()] = end;
    return VertexId{end};
  }

  // One step from a vertex, along the steepest of its edges and triangles; nothing from a top. A
  // path through a triangle is followed to its end.
  std::optional<VertexId> step(VertexId v) {
    double steepest = 0;
    HalfEdgeId best;
    bool is_edge = true;
    mesh_.for_each_outgoing(v, [&](HalfEdgeId h) {
      const VertexId w = mesh_.target(h);
      const double along = (value(w) - value(v)) / (place(w) - place(v)).norm();
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

// By triangle the extremum of an index that its path leads to.
std::vector<std::uint32_t> extrema(const SurfaceMesh& mesh, const geometry::IndexedMesh& places,
                                   const morse::MorseFunction& function, int index,
                                   const std::vector<morse::CriticalPoint>& points) {
  std::vector<double> values;
  values.reserve(places.positions.size());
  for (const Point& p : places.positions) values.push_back(function(p));
  Ascent ascent(mesh, places.positions, values);
  std::vector<std::uint32_t> nearest(places.positions.size(), none);  // by top
  std::vector<std::uint32_t> result;
  result.reserve(mesh.triangle_count());
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    const VertexId v = ascent.top_from(TriangleId{t});
    std::uint32_t& found = nearest[v.index()];
    if (found == none) found = nearest_of(points, index, places.positions[v.index()]);
    result.push_back(found);
  }
  return result;
}

}  // namespace

FlowRegions flow_regions(const geometry::IndexedMesh& mesh, const morse::MorseFunction& function,
                         const std::vector<morse::CriticalPoint>& points, unsigned threads) {
  const SurfaceMesh surface = geometry::closed_mesh(mesh.positions.size(), mesh.triangles).mesh;
  std::vector<std::uint32_t> up, down;
  geometry::do_both(
      threads, [&] { up = extrema(surface, mesh, function, 2, points); },
      [&] { down = extrema(surface, mesh, function.reversed(), 0, points); });
  FlowRegions result;
  for (std::size_t t = 0; t < up.size(); ++t) result.regions.push_back({down[t], up[t]});
  std::ranges::sort(result.regions);
  const auto repeated = std::ranges::unique(result.regions);
  result.regions.erase(repeated.begin(), repeated.end());
  for (std::size_t t = 0; t < up.size(); ++t) {
    const auto at = std::ranges::lower_bound(result.regions, FlowRegion{down[t], up[t]});
    result.of_triangle.push_back(static_cast<std::uint32_t>(at - result.regions.begin()));
  }
  return result;
}

}  // namespace morskin::app
