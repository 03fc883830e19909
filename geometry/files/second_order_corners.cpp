#include "geometry/files/second_order_corners.h"

#include <utility>

#include "geometry/error.h"

namespace morskin::geometry::mesh_formats {

CornersOnly::CornersOnly(std::vector<Point> points)
    : points_(std::move(points)), is_middle_(points_.size(), 0) {}

IndexedMesh CornersOnly::take(const std::string& source) && {
  IndexedMesh mesh;
  std::vector<std::uint32_t> index(points_.size(), 0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (is_middle_[i] != 0) continue;
    index[i] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(points_[i]);
  }
  mesh.triangles = std::move(triangles_);
  for (TriangleCorners& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      if (is_middle_[corner] != 0) {
        throw UnreadableInput(source + ": point " + std::to_string(corner) + ", from 0, is a " +
                              "corner of one triangle and inside an edge of another; write the "
                              "mesh again");
      }
      corner = index[corner];
    }
  }
  return mesh;
}

}  // namespace morskin::geometry::mesh_formats
