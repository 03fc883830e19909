#include "morskin/second_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "certify/curved_triangle.h"
#include "geometry/error.h"

namespace morskin {

namespace {

using geometry::IndexedMesh;
using geometry::Point;
using geometry::SecondOrderTriangle;

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
  std::ranges::sort(edges);
  const auto rest = std::ranges::unique(edges);
  edges.erase(rest.begin(), rest.end());
  return edges;
}

[[noreturn]] void refuse(const std::string& what) {
  throw geometry::RefusedInput(what + "; make a finer mesh with a smaller -C, or one of order 1");
}

/// Adds a node for each edge, on the surface.
void add_nodes(SecondOrder& to, const surface::Surface& surface, std::span<const Edge> edges) {
  std::vector<Point>& nodes = to.mesh.nodes;
  nodes.reserve(nodes.size() + edges.size());
  for (const auto& [a, b] : edges) {
    const Point middle = (nodes[a] + nodes[b]) / 2;
    const std::optional<surface::SurfacePoint> node = surface.project(middle, to.cells[a]);
    if (!node) {
      refuse("the middle of the edge between the vertices " + std::to_string(a) + " and " +
             std::to_string(b) + " does not reach the skin");
    }
    nodes.push_back(node->position);
    to.cells.push_back(node->cell);
    to.ends.push_back(a);
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

/// Adds a triangle's area and Jacobian. @throws geometry::RefusedInput
void measure(SecondOrder& to, std::size_t number) {
  const SecondOrderTriangle& triangle = to.mesh.triangles[number];
  certify::CurvedTriangle nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = to.mesh.nodes[triangle[k]];
  const std::optional<double> jacobian = certify::least_jacobian(nodes);
  if (!jacobian) {
    refuse("the Jacobian of the second-order triangle " + std::to_string(number) +
           ", with corners " + std::to_string(triangle[0]) + ", " + std::to_string(triangle[1]) +
           " and " + std::to_string(triangle[2]) + ", is not proved positive");
  }
  to.least_jacobian = std::min(to.least_jacobian, *jacobian);
  to.area += certify::curved_area(nodes);
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
    measure(result, result.mesh.triangles.size() - 1);
  }
  return result;
}

}  // namespace morskin
