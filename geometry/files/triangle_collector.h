#pragma once

// Collects the triangles, flat or curved, of a file that may hold either.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/files/mesh_formats.h"

namespace morskin::geometry::mesh_formats {

/// Takes points and the triangles of a file one by one.
class TriangleCollector {
 public:
  explicit TriangleCollector(std::vector<Point> points) : points_(std::move(points)) {}

  std::size_t point_count() const { return points_.size(); }
  /// A flat triangle. @pre each corner < point_count()
  void add(const TriangleCorners& corners) { corners_.push_back(corners); }
  /// A curved one. @param in_edges  the nodes between a and b, b and c, c and a
  void add(const TriangleCorners& corners, const std::array<std::uint32_t, 3>& in_edges) {
    corners_.push_back(corners);
    in_edges_.push_back(in_edges);
  }

  /// The mesh of all points but the nodes inside edges, in their order.
  /// @throws UnreadableInput  flat and curved triangles in one file, or a corner of one triangle
  ///                          that is a node inside another's edge
  ParsedMesh take(const std::string& source) &&;

 private:
  std::vector<Point> points_;
  TriangleList corners_, in_edges_;  ///< by triangle
};

}  // namespace morskin::geometry::mesh_formats
