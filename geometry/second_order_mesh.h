#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// Corners a, b, c, counter-clockwise seen from outside, then the nodes between a and b, b and c,
/// c and a: the order of VTK_QUADRATIC_TRIANGLE and of Gmsh's element 9.
using SecondOrderTriangle = std::array<std::uint32_t, 6>;

/// A mesh whose triangles are curved: with the barycentric coordinates l of a point,
///     x(l) = sum over corners i of l_i (2 l_i - 1) x_i + sum over edges ij of 4 l_i l_j x_ij.
struct SecondOrderMesh {
  std::vector<Point> nodes;  ///< Angstrom; the vertices of a flat mesh, then one for each edge
  std::vector<SecondOrderTriangle> triangles;  ///< each index < nodes.size()

  bool operator==(const SecondOrderMesh&) const = default;
};

}  // namespace morskin::geometry
