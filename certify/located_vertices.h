#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "certify/tube.h"
#include "geometry/indexed_mesh.h"
#include "geometry/run.h"
#include "geometry/unfilled.h"
#include "surface/surface.h"

namespace morskin::certify {

/// What is known at a vertex, beside its position: its cell, and low <= G <= high. The bounds are
/// rounded outwards to floats, for a certificate holds one of these for each vertex.
struct LocatedVertex {
  Vector half_gradient;  ///< N, Angstrom
  float low, high;       ///< Angstrom^2
  float error;           ///< of the length scale times the normal of at(), off N, Angstrom
  surface::CellId cell;

  double max_value() const { return std::max(-low, high); }
  double length_scale() const { return half_gradient.norm(); }
  /// @param x  the vertex's position
  SurfacePoint at(const Point& x) const {
    const double rho = length_scale();
    return {x, rho > 0 ? Vector(half_gradient / rho) : Vector::Zero(), rho, cell};
  }
};

using LocatedVertices = geometry::UnfilledVector<LocatedVertex>;

/// A mesh near a surface with what is known of its vertices.
struct LocatedMesh {
  const geometry::IndexedMesh& mesh;
  std::span<const LocatedVertex> vertices;
  const surface::Surface& surface;

  const Point& position(std::uint32_t v) const { return mesh.positions[v]; }
  SurfacePoint point(std::uint32_t v) const { return vertices[v].at(position(v)); }
  /// The corners of a triangle, which live no longer than this.
  struct CornerPoints {
    std::array<SurfacePoint, 3> points;
    operator Corners() const& { return {&points[0], &points[1], &points[2]}; }
    operator Corners() const&& = delete;
  };
  CornerPoints corners(const geometry::TriangleCorners& triangle) const {
    const auto& [a, b, c] = triangle;
    return {{point(a), point(b), point(c)}};
  }
  TriangleBounds shape(const geometry::TriangleCorners& triangle) const {
    const auto& [a, b, c] = triangle;
    return triangle_bounds(position(a), position(b), position(c));
  }
  CornerBounds corner_bounds(const geometry::TriangleCorners& triangle) const {
    const LocatedVertex &a = vertices[triangle[0]], &b = vertices[triangle[1]],
                        &c = vertices[triangle[2]];
    return {{a.max_value(), b.max_value(), c.max_value()}, std::max({a.error, b.error, c.error})};
  }
};

/// The side that an edge is measured from, so that it is once where triangles are oriented alike:
/// where one has it from the smaller id to the larger or, at the end of an open mesh, where the
/// only one has it. Triangles that run along an edge the same way measure it once each.
class EdgeSides {
 public:
  EdgeSides() = default;  ///< of a closed oriented mesh
  explicit EdgeSides(std::span<const geometry::TriangleCorners> triangles);  ///< of any mesh

  bool is_measured(std::uint32_t from, std::uint32_t to) const {
    return from < to || (is_open_ && !std::ranges::binary_search(upwards_, std::pair(to, from)));
  }

 private:
  bool is_open_ = false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> upwards_;  ///< from the smaller id; sorted
};

/// Finds the cell of each vertex of any mesh, with bounds on G and N there.
class VertexLocator {
 public:
  VertexLocator(const geometry::IndexedMesh& mesh, const surface::Surface& surface)
      : mesh_(mesh),
        surface_(surface),
        vertices_(mesh.positions.size()),
        is_located_(mesh.positions.size(), 0) {}

  /// Locates those of the vertices [begin, end) whose hints are right. Threads may run on disjoint
  /// ranges at once.
  /// @param hints  by vertex, a cell; any values
  void locate_hinted(std::span<const surface::CellId> hints, std::size_t begin, std::size_t end);
  /// Locates the rest, by walks from a neighbour's cell: O(n) on ordinary meshes.
  /// @throws geometry::Stopped
  void locate_rest(const geometry::Run& run = geometry::Run());

  /// By vertex. @pre locate_rest() has been called.
  LocatedVertices take_vertices() { return std::move(vertices_); }

 private:
  void locate(std::uint32_t v, surface::CellId start);
  void set(std::size_t v, surface::CellId cell);

  const geometry::IndexedMesh& mesh_;
  const surface::Surface& surface_;
  LocatedVertices vertices_;      ///< made where they are located
  std::vector<char> is_located_;  ///< by vertex
};

/// All vertices, by walks. @return by vertex
/// @throws geometry::Stopped
LocatedVertices locate_with_bounds(const geometry::IndexedMesh& mesh,
                                   const surface::Surface& surface,
                                   const geometry::Run& run = geometry::Run());
std::vector<surface::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                   const surface::Surface& surface,
                                                   const geometry::Run& run = geometry::Run());

/// @return by point
std::vector<surface::CellId> cells_of(std::span<const surface::SurfacePoint> points);

}  // namespace morskin::certify
