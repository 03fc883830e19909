#pragma once

#include <optional>
#include <utility>

#include "geometry/indexed_mesh.h"
#include "geometry/mesh_data.h"
#include "geometry/surface_mesh.h"
#include "surface/surface_point.h"

namespace morskin::surface {

/// A triangle mesh whose vertices are points of a surface: connectivity, and data that follow it.
struct Mesh {
  geometry::SurfaceMesh surface;
  geometry::VertexData<SurfacePoint> points{surface, {Point::Zero(), Vector::Zero(), 0, CellId{}}};
  /// Recorded only if asked for: emplace it before the first triangle is laid.
  std::optional<geometry::TriangleBirths> births;

  Mesh() = default;
  /// Its points are to be set one by one.
  explicit Mesh(geometry::SurfaceMesh connectivity) : surface(std::move(connectivity)) {}
  Mesh(const Mesh& other) { assign(other); }
  Mesh(Mesh&& other) { assign(std::move(other)); }
  ~Mesh() = default;
  Mesh& operator=(const Mesh& other) { return assign(other); }
  Mesh& operator=(Mesh&& other) { return assign(std::move(other)); }

  const SurfacePoint& at(geometry::VertexId v) const { return points[v]; }
  const Point& position(geometry::VertexId v) const { return points[v].position; }

  geometry::VertexId add_vertex(SurfacePoint p) {  // a copy: it may be one of these points
    const geometry::VertexId v = surface.add_vertex();
    points[v] = p;
    return v;
  }

 private:
  /// Data first: then they have as many elements as the connectivity that comes.
  template <class Other>
  Mesh& assign(Other&& other) {
    if (this == &other) return *this;
    points = std::forward<Other>(other).points;
    births.reset();
    if (other.births) births.emplace(surface) = *std::forward<Other>(other).births;
    surface = std::forward<Other>(other).surface;
    return *this;
  }
};

/// The mesh as files hold it. @pre no vertex has been removed since it was compacted
inline geometry::IndexedMesh indexed_mesh(const Mesh& mesh) {
  geometry::IndexedMesh result;
  result.triangles = mesh.surface.triangle_list();
  result.positions.reserve(mesh.points.size());
  for (const SurfacePoint& p : mesh.points) result.positions.push_back(p.position);
  return result;
}

}  // namespace morskin::surface
