#pragma once

#include "front/front.h"
#include "tests/support/test.h"

namespace morskin::support {

using namespace front;
using geometry::SurfaceMesh;

/// A point of a flat skin, the plane z = 0 with length scale 1.
inline SurfacePoint flat(double x, double y) {
  return {{x, y, 0}, Vector::UnitZ(), 1, geometry::CellId{}};
}

/// A front round regular fans of triangles laid by hand on the plane.
struct Plane {
  Mesh mesh;
  Front front{mesh};

  /// A fan about a centre; the front runs counter-clockwise round it, bare plane outside. Entry k
  /// leaves the corner at `angle` + k 2 pi / n.
  std::vector<FrontEdgeId> fan(double x, double y, double radius, double angle, int n = 6) {
    const VertexId centre = mesh.add_vertex(flat(x, y));
    std::vector<VertexId> rim;
    for (int k = 0; k < n; ++k) {
      const double a = angle + 2 * M_PI * k / n;
      rim.push_back(mesh.add_vertex(flat(x + radius * std::cos(a), y + radius * std::sin(a))));
    }
    return open(centre, rim);
  }
  /// A fan about a centre, given its rim counter-clockwise.
  std::vector<FrontEdgeId> open(VertexId centre, const std::vector<VertexId>& rim) {
    std::vector<geometry::TriangleId> fan;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      fan.push_back(mesh.surface.add_triangle(centre, rim[k], rim[(k + 1) % rim.size()]));
    }
    std::vector<HalfEdgeId> outer;
    for (std::size_t k = 0; k < fan.size(); ++k) {
      mesh.surface.glue(SurfaceMesh::half_edge(fan[k], 0),
                        SurfaceMesh::half_edge(fan[(k + fan.size() - 1) % fan.size()], 2));
      outer.push_back(SurfaceMesh::half_edge(fan[k], 1));
    }
    return front.open_polygon(outer);
  }
  std::vector<FrontEdgeId> open_edges() const {
    std::vector<FrontEdgeId> open;
    for (std::size_t e = 0; e < front.capacity(); ++e) {
      if (front[FrontEdgeId{e}].is_open) open.emplace_back(e);
    }
    return open;
  }
};

}  // namespace morskin::support
