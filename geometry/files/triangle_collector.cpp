#include "geometry/files/triangle_collector.h"

#include <utility>

#include "geometry/error.h"

namespace morskin::geometry::mesh_formats {

ParsedMesh TriangleCollector::take(const std::string& source) && {
  if (in_edges_.empty()) return {{std::move(points_), std::move(corners_)}, std::nullopt};
  if (in_edges_.size() != corners_.size()) {
    throw UnreadableInput(source +
                          ": has triangles of three nodes beside those of six; write one "
                          "kind");
  }
  std::vector<char> is_in_edge(points_.size(), 0);
  for (const auto& nodes : in_edges_) {
    for (const std::uint32_t node : nodes) is_in_edge[node] = 1;
  }
  SecondOrderMesh curved;
  std::vector<std::uint32_t> index(points_.size());
  const auto add_nodes = [&](bool in_edges) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if ((is_in_edge[i] != 0) != in_edges) continue;
      index[i] = static_cast<std::uint32_t>(curved.nodes.size());
      curved.nodes.push_back(points_[i]);
    }
  };
  add_nodes(false);
  IndexedMesh mesh{curved.nodes, {}};
  add_nodes(true);
  for (std::size_t t = 0; t < corners_.size(); ++t) {
    const auto& [a, b, c] = corners_[t];
    const auto& [ab, bc, ca] = in_edges_[t];
    for (const std::uint32_t corner : corners_[t]) {
      if (is_in_edge[corner] == 0) continue;
      throw UnreadableInput(source + ": point " + std::to_string(corner) + ", from 0, is a " +
                            "corner of one triangle and inside an edge of another; write the "
                            "mesh again");
    }
    mesh.triangles.push_back({index[a], index[b], index[c]});
    curved.triangles.push_back({index[a], index[b], index[c], index[ab], index[bc], index[ca]});
  }
  return {std::move(mesh), std::move(curved)};
}

}  // namespace morskin::geometry::mesh_formats
