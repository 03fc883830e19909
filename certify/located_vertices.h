#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "surface/surface.h"

namespace morskin::certify {

/// Finds the cell of each vertex of any mesh, with the normal and length scale of the cell's
/// formula there.
class VertexLocator {
 public:
  VertexLocator(const geometry::IndexedMesh& mesh, const surface::Surface& surface)
      : mesh_(mesh),
        surface_(surface),
        points_(mesh.positions.size()),
        is_located_(mesh.positions.size(), 0) {}

  /// Locates those of the vertices [begin, end) whose hints are right. Threads may run on disjoint
  /// ranges at once.
  /// @param hints  by vertex, a cell; any values
  void locate_hinted(std::span<const surface::CellId> hints, std::size_t begin, std::size_t end);
  /// Locates the rest, by walks from a neighbour's cell: O(n) on ordinary meshes.
  void locate_rest();
  /// By vertex. @pre locate_rest() has been called.
  std::vector<surface::SurfacePoint> take() { return std::move(points_); }

 private:
  void locate(std::uint32_t v, surface::CellId start);

  const geometry::IndexedMesh& mesh_;
  const surface::Surface& surface_;
  std::vector<surface::SurfacePoint> points_;
  std::vector<char> is_located_;  ///< by vertex
};

/// All vertices, by walks. @return by vertex
std::vector<surface::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                   const surface::Surface& surface);

}  // namespace morskin::certify
