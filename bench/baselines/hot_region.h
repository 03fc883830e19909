#pragma once

/// The special sampling about a critical point: rings of points on the quadric, and the strips of
/// triangles between them (papers/5-dynamic.md).
///
/// A region of the surface is mapped to the plane, seen from outside, as nested closed polygons,
/// each counter-clockwise; a strip joins each to the next one inside.

#include <array>
#include <vector>

#include "bench/baselines/metamorphoses.h"
#include "bench/baselines/moving_mesh.h"
#include "geometry/orthogonal.h"

namespace morskin::baselines {

/// A closed polygon of the mesh, counter-clockwise seen from outside, the inner side on its left.
using Ring = std::vector<VertexId>;

/// The frame of a critical point's quadric: its axis and two directions across it.
struct Frame {
  Point centre;
  Vector axis;
  geometry::TangentFrame across;
  explicit Frame(const Patch& patch, double direction = 1);

  double axial(const Point& x) const { return axis.dot(x - centre); }
  double radial(const Point& x) const {
    const Vector u = x - centre;
    return (u - axis.dot(u) * axis).norm();
  }
  Point point(double radial, double azimuth, double axial) const {
    return centre + radial * across.direction(azimuth) + axial * axis;
  }
};

/// New vertices on a circle about the axis, counter-clockwise about it, at the time set.
/// @param turn  of the first vertex, radians
Ring add_ring(MovingMesh& mesh, const Frame& frame, CellId cell, double radial, double axial,
              double turn);

using Corners = std::array<VertexId, 3>;
/// The strip between two closed rings of three vertices or more: of all strips, that with the
/// smallest sum of squared rungs, given that the outer ring's first vertex has a rung to the
/// nearest of the inner one (Fuchs, Kedem & Uselton 1977). It is an annulus whatever the rings'
/// shapes.
void join(MovingMesh& mesh, const Ring& outer, const Ring& inner, std::vector<Corners>& triangles);
/// The triangles between a ring and a vertex inside.
void close(const Ring& ring, VertexId centre, std::vector<Corners>& triangles);

/// Puts triangles into the mesh and glues them to each other and to the boundary there is.
/// @param open  the boundary half-edges of the mesh that they meet
/// @return whether no boundary is left
bool add_triangles(SurfaceMesh& surface, const std::vector<Corners>& triangles,
                   const std::vector<HalfEdgeId>& open);

/// A whole sphere about a centre, as rings from pole to pole.
/// @param radius  Angstrom
std::vector<Corners> sphere_template(MovingMesh& mesh, const Frame& frame, CellId cell,
                                     double radius);
/// One sheet of axial^2 - radial^2 = h^2 inside a loop about the axis, on the side of `frame.axis`.
std::vector<Corners> cap_template(MovingMesh& mesh, const Frame& frame, CellId cell, double h,
                                  const Ring& loop);
/// The tube radial^2 - axial^2 = h^2 between two loops, the upper one with the tube on its left
/// too.
std::vector<Corners> tube_template(MovingMesh& mesh, const Frame& frame, CellId cell, double h,
                                   const Ring& lower, const Ring& upper);

}  // namespace morskin::baselines
