#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "surface/surface.h"

namespace morskin::certify {

/// What is proved of G and N at a vertex: low <= G <= high, and N differs from the located point's
/// length scale times its normal by at most `error`. Rounded outwards to floats.
struct VertexBounds {
  float low, high;  ///< Angstrom^2
  float error;      ///< Angstrom

  double max_value() const { return std::max(-low, high); }
};

/// Finds the cell of each vertex of any mesh, with bounds on G and N there.
class VertexLocator {
 public:
  VertexLocator(const geometry::IndexedMesh& mesh, const surface::Surface& surface)
      : mesh_(mesh),
        surface_(surface),
        points_(mesh.positions.size()),
        bounds_(mesh.positions.size()),
        is_located_(mesh.positions.size(), 0) {}

  /// Locates those of the vertices [begin, end) whose hints are right. Threads may run on disjoint
  /// ranges at once.
  /// @param hints  by vertex, a cell; any values
  void locate_hinted(std::span<const surface::CellId> hints, std::size_t begin, std::size_t end);
  /// Locates the rest, by walks from a neighbour's cell: O(n) on ordinary meshes.
  void locate_rest();

  /// By vertex. @pre locate_rest() has been called.
  std::vector<surface::SurfacePoint> take_points() { return std::move(points_); }
  std::vector<VertexBounds> take_bounds() { return std::move(bounds_); }

 private:
  void locate(std::uint32_t v, surface::CellId start);
  void set(std::size_t v, surface::CellId cell);

  const geometry::IndexedMesh& mesh_;
  const surface::Surface& surface_;
  std::vector<surface::SurfacePoint> points_;
  std::vector<VertexBounds> bounds_;
  std::vector<char> is_located_;  ///< by vertex
};

/// All vertices, by walks. @return by vertex
std::vector<surface::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                   const surface::Surface& surface);

/// @return by point
std::vector<surface::CellId> cells_of(std::span<const surface::SurfacePoint> points);

}  // namespace morskin::certify
