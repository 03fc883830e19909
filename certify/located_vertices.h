#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "surface/surface.h"

namespace morskin::certify {

/// Finds for each vertex of any mesh its mixed cell, and the normal and length scale that the skin
/// would have there.
class VertexLocator {
 public:
  VertexLocator(const geometry::IndexedMesh& mesh, const surface::Surface& surface)
      : mesh_(mesh),
        surface_(surface),
        points_(mesh.positions.size()),
        is_located_(mesh.positions.size(), 0) {}

  /// Locates those of the vertices [begin, end) that lie in the cells which somebody says they lie
  /// in. From any thread, for vertices that no other is at.
  /// @param cells  by vertex; any numbers
  void locate_where_said(std::span<const surface::CellId> cells, std::size_t begin,
                         std::size_t end);
  /// Locates all that are left, by walks from a neighbour's cell: O(n) on ordinary meshes.
  void locate_rest();
  /// @pre all are located
  std::vector<surface::SurfacePoint> take() { return std::move(points_); }

 private:
  void place(std::uint32_t v, surface::CellId start);

  const geometry::IndexedMesh& mesh_;
  const surface::Surface& surface_;
  std::vector<surface::SurfacePoint> points_;
  std::vector<char> is_located_;  ///< by vertex
};

/// All at once, by walks.
std::vector<surface::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                   const surface::Surface& surface);

}  // namespace morskin::certify
