#include "morskin/second_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "geometry/orthogonal.h"
#include "geometry/sort_unique.h"

namespace morskin {

namespace {

using geometry::IndexedMesh;
using geometry::Point;
using geometry::SecondOrderTriangle;
using geometry::Vector;
using surface::SurfacePoint;

/// An edge from its lower to its higher vertex.
using Edge = std::array<std::uint32_t, 2>;

Edge edge_of(const geometry::TriangleCorners& t, std::size_t k) {
  const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
  return {low, high};
}

std::vector<Edge> edges_of(const IndexedMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const geometry::TriangleCorners& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(edge_of(t, k));
  }
  geometry::sort_unique(edges);
  return edges;
}

[[noreturn]] void refuse(const std::string& what) {
  throw geometry::RefusedInput(what + "; make a finer mesh with a smaller -C, or one of order 1");
}

/// Farther from the middle the distance to the surface and the angle to its normals grow again.
constexpr double max_shift = 1.0 / 8;

/// Where the parabola over an edge has its middle that leaves both ends along the surface: seen
/// from the middle of the edge, over half its length.
double parabola_shift(const SurfacePoint& a, const SurfacePoint& b) {
  const Vector half = (b.position - a.position) / 2;
  const Vector up = geometry::unit_orthogonal_part(a.normal + b.normal, half.normalized());
  const auto slope = [&](const Vector& normal) { return -normal.dot(half) / normal.dot(up); };
  const double at_a = slope(a.normal), at_b = slope(b.normal);
  const double shift = -(at_a + at_b) / (at_a - at_b) / 2;
  return std::isfinite(shift) ? std::clamp(shift, -max_shift, max_shift) : 0;
}

/// The node of an edge from where the surface is reached from this far beside the middle.
SurfacePoint node_of(const surface::Surface& surface, const SecondOrder& to, const Edge& edge,
                     double shift) {
  const auto& [a, b] = edge;
  const Point& start = to.mesh.nodes[a];
  const Vector half = (to.mesh.nodes[b] - start) / 2;
  const std::optional<SurfacePoint> node = surface.project(start + (1 + shift) * half, to.cells[a]);
  if (!node && shift != 0) return node_of(surface, to, edge, 0);
  if (!node) {
    refuse("the middle of the edge between the vertices " + std::to_string(a) + " and " +
           std::to_string(b) + " does not reach the skin");
  }
  return *node;
}

/// Adds a node for each edge, on the surface.
void add_nodes(SecondOrder& to, const surface::Surface& surface, std::span<const Edge> edges) {
  std::vector<SurfacePoint> ends;
  for (std::size_t v = 0; v < to.mesh.nodes.size(); ++v) {
    ends.push_back(surface.at(to.mesh.nodes[v], to.cells[v]));
  }
  to.mesh.nodes.reserve(to.mesh.nodes.size() + edges.size());
  for (const Edge& edge : edges) {
    const double shift = parabola_shift(ends[edge[0]], ends[edge[1]]);
    const SurfacePoint node = node_of(surface, to, edge, shift);
    to.mesh.nodes.push_back(node.position);
    to.cells.push_back(node.cell);
    to.ends.push_back(edge[0]);
  }
}

SecondOrderTriangle curved(const geometry::TriangleCorners& t, std::size_t vertices,
                           std::span<const Edge> edges) {
  SecondOrderTriangle result{t[0], t[1], t[2], 0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto edge = std::ranges::lower_bound(edges, edge_of(t, k));
    result[3 + k] =
        static_cast<std::uint32_t>(vertices + static_cast<std::size_t>(edge - edges.begin()));
  }
  return result;
}

/// Moves the nodes of triangles that are not proved to where the middles of their edges lead; again
/// for triangles that this leaves unproved.
void center_unproved(SecondOrder& to, const surface::Surface& surface,
                     std::span<const Edge> edges) {
  const std::size_t vertices = to.mesh.nodes.size() - edges.size();
  std::vector<char> is_centered(edges.size(), 0);
  for (bool has_moved = true; has_moved;) {
    has_moved = false;
    for (const SecondOrderTriangle& triangle : to.mesh.triangles) {
      if (certify::least_jacobian(certify::nodes_of(to.mesh, triangle))) continue;
      for (const std::uint32_t node : std::span(triangle).last<3>()) {
        if (std::exchange(is_centered[node - vertices], 1) != 0) continue;
        const SurfacePoint moved = node_of(surface, to, edges[node - vertices], 0);
        to.mesh.nodes[node] = moved.position;
        to.cells[node] = moved.cell;
        has_moved = true;
      }
    }
  }
}

/// @throws geometry::RefusedInput
void check_and_measure(SecondOrder& curved) {
  curved.measures = certify::measure_curved(curved.mesh);
  if (const auto t = curved.measures.first_unproved) {
    const SecondOrderTriangle& triangle = curved.mesh.triangles[*t];
    refuse("the Jacobian of the second-order triangle " + std::to_string(*t) + ", with corners " +
           std::to_string(triangle[0]) + ", " + std::to_string(triangle[1]) + " and " +
           std::to_string(triangle[2]) + ", is not proved positive");
  }
  const std::string objection = certify::objection_to_nodes(curved.mesh);
  if (!objection.empty()) refuse(objection);
}

}  // namespace

SecondOrder second_order(const surface::Surface& surface, const IndexedMesh& mesh,
                         std::span<const geometry::CellId> cells) {
  SecondOrder result;
  result.mesh.nodes = mesh.positions;
  result.cells.assign(cells.begin(), cells.end());
  const std::vector<Edge> edges = edges_of(mesh);
  add_nodes(result, surface, edges);
  for (const geometry::TriangleCorners& t : mesh.triangles) {
    result.mesh.triangles.push_back(curved(t, mesh.positions.size(), edges));
  }
  center_unproved(result, surface, edges);
  check_and_measure(result);
  return result;
}

}  // namespace morskin
