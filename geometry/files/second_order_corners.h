#pragma once

// What remains of files that may hold curved triangles when only their corners are read.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/indexed_mesh.h"

namespace morskin::geometry::mesh_formats {

/// Takes points and the triangles of a file one by one.
class CornersOnly {
 public:
  explicit CornersOnly(std::vector<Point> points);

  std::size_t point_count() const { return points_.size(); }
  void add(const TriangleCorners& corners) { triangles_.push_back(corners); }
  /// A node inside an edge. @pre node < point_count()
  void add_middle(std::uint32_t node) { is_middle_[node] = 1; }

  /// The mesh of all points but the nodes inside edges, in their order.
  /// @throws UnreadableInput  a triangle's corner is a node inside another's edge
  IndexedMesh take(const std::string& source) &&;

 private:
  std::vector<Point> points_;
  TriangleList triangles_;
  std::vector<char> is_middle_;  ///< by point
};

}  // namespace morskin::geometry::mesh_formats
