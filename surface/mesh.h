#pragma once

#include <vector>

#include "geometry/parallel.h"
#include "geometry/surface_mesh.h"
#include "surface/surface_point.h"

namespace morskin::surface {

/// A triangle mesh whose vertices are points of a surface: connectivity, and by vertex the surface
/// point.
struct Mesh {
  geometry::SurfaceMesh surface;
  std::vector<SurfacePoint> points;  ///< by vertex

  const SurfacePoint& at(geometry::VertexId v) const { return points[v.index()]; }
  const Point& position(geometry::VertexId v) const { return points[v.index()].position; }

  geometry::VertexId add_vertex(const SurfacePoint& p) {
    points.push_back(p);
    return surface.add_vertex();
  }
  geometry::SurfaceMesh::Room add_room() {
    points.emplace_back();
    return surface.add_room();
  }
  /// Takes over another mesh as geometry::SurfaceMesh::append() does, and leaves nothing of it.
  /// @param threads  at most; for a big mesh one, so that not all is there twice at once
  void append(Mesh&& other, unsigned threads = 1) {
    constexpr std::size_t big = std::size_t{1} << 20;
    geometry::do_both(
        points.size() < big ? threads : 1,
        [&] {
          surface.append(other.surface);
          other.surface = {};
        },
        [&] {
          points.reserve(geometry::SurfaceMesh::with_room(points.size() + other.points.size()));
          points.insert(points.end(), other.points.begin(), other.points.end());
          std::vector<SurfacePoint>().swap(other.points);
        });
  }

  /// Drops removed triangles and vertices without triangles, keeping the order of the rest.
  /// @param threads  at most
  /// @return the new ids
  geometry::SurfaceMesh::Renaming compact(unsigned threads = 1) {
    geometry::SurfaceMesh::Renaming renamed = surface.renaming();
    geometry::do_both(
        threads, [&] { surface.compact(renamed); },
        [&] {
          std::size_t kept = 0;
          for (std::size_t v = 0; v < points.size(); ++v) {
            if (renamed.vertices[v]) points[kept++] = points[v];
          }
          points.resize(kept);
        });
    return renamed;
  }
};

}  // namespace morskin::surface
