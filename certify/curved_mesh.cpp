#include "certify/curved_mesh.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "certify/located_vertices.h"

namespace morskin::certify {

namespace {

using geometry::Point;
using geometry::SecondOrderMesh;
using geometry::SecondOrderTriangle;

/// An edge of a triangle, with the node that the triangle has in it.
struct CurvedEdge {
  std::uint32_t low, high, node;

  bool has_ends_of(const CurvedEdge& other) const { return low == other.low && high == other.high; }
  std::string name() const {
    return "the edge between the vertices " + std::to_string(low) + " and " + std::to_string(high);
  }
};

std::vector<CurvedEdge> edges_of(const SecondOrderMesh& mesh) {
  std::vector<CurvedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const SecondOrderTriangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({low, high, t[3 + k]});
    }
  }
  return edges;
}

}  // namespace

CurvedTriangle nodes_of(const SecondOrderMesh& mesh, const SecondOrderTriangle& triangle) {
  CurvedTriangle nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = mesh.nodes[triangle[k]];
  return nodes;
}

CurvedMeasures measure_curved(const SecondOrderMesh& mesh) {
  CurvedMeasures result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const CurvedTriangle nodes = nodes_of(mesh, mesh.triangles[t]);
    result.area += curved_area(nodes);
    const std::optional<double> jacobian = least_jacobian(nodes);
    if (jacobian) result.least_jacobian = std::min(result.least_jacobian, *jacobian);
    if (!jacobian && !result.first_unproved) result.first_unproved = t;
  }
  return result;
}

std::string objection_to_nodes(const SecondOrderMesh& mesh) {
  std::vector<CurvedEdge> edges = edges_of(mesh);
  std::ranges::sort(edges, {},
                    [](const CurvedEdge& e) { return std::tuple(e.low, e.high, e.node); });
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!edges[i].has_ends_of(edges[i - 1]) || edges[i].node == edges[i - 1].node) continue;
    return edges[i].name() + " has the nodes " + std::to_string(edges[i - 1].node) + " and " +
           std::to_string(edges[i].node);
  }
  for (const CurvedEdge& edge : edges) {
    const Point &a = mesh.nodes[edge.low], &b = mesh.nodes[edge.high];
    const double off = (mesh.nodes[edge.node] - (a + b) / 2).norm();
    if (off < (b - a).norm() / 2) continue;
    return "node " + std::to_string(edge.node) + " is no nearer to the middle of " + edge.name() +
           " than they are";
  }
  std::ranges::sort(edges, {},
                    [](const CurvedEdge& e) { return std::tuple(e.node, e.low, e.high); });
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].node != edges[i - 1].node || edges[i].has_ends_of(edges[i - 1])) continue;
    return "node " + std::to_string(edges[i].node) + " lies in " + edges[i - 1].name() +
           " and in " + edges[i].name();
  }
  return "";
}

Residuals node_residuals(const SecondOrderMesh& mesh, std::size_t vertices,
                         const surface::Surface& surface, const geometry::Run& run) {
  // The nodes in a triangle's edges are neighbours, whose cells are near each other.
  geometry::IndexedMesh in_edges;
  in_edges.positions.assign(mesh.nodes.begin() + static_cast<std::ptrdiff_t>(vertices),
                            mesh.nodes.end());
  const auto first = static_cast<std::uint32_t>(vertices);
  for (const auto& [a, b, c, ab, bc, ca] : mesh.triangles) {
    in_edges.triangles.push_back({ab - first, bc - first, ca - first});
  }
  const LocatedVertices nodes = locate_with_bounds(in_edges, surface, run);
  Residuals result =
      residuals({in_edges, nodes, surface}, is_single_precision(in_edges.positions), run);
  if (result.first_off_skin) result.first_off_skin->first += vertices;
  return result;
}

}  // namespace morskin::certify
