#pragma once

#include <vector>

#include "geometry/surface_mesh.h"
#include "skin/skin_surface.h"

namespace morskin::skin {

/// A triangle mesh whose vertices are points of the skin: connectivity, and by vertex the surface
/// point.
struct SkinMesh {
  geometry::SurfaceMesh surface;
  std::vector<SurfacePoint> points;  ///< by vertex

  const SurfacePoint& at(geometry::VertexId v) const { return points[v.index()]; }
  const Point& position(geometry::VertexId v) const { return points[v.index()].position; }

  geometry::VertexId add_vertex(const SurfacePoint& p) {
    points.push_back(p);
    return surface.add_vertex();
  }
  void append(const SkinMesh& other) {
    surface.append(other.surface);
    points.reserve(geometry::SurfaceMesh::with_room(points.size() + other.points.size()));
    points.insert(points.end(), other.points.begin(), other.points.end());
  }
};

}  // namespace morskin::skin
