#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "skin/skin_surface.h"

namespace morskin::refine {

/// Finds for each vertex of any mesh its mixed cell, and the normal and length scale that the skin
/// would have there.
class VertexLocator {
 public:
  VertexLocator(const geometry::IndexedMesh& mesh, const skin::SkinSurface& skin)
      : mesh_(mesh),
        skin_(skin),
        points_(mesh.positions.size()),
        is_located_(mesh.positions.size(), 0) {}

  /// Locates those of the vertices [begin, end) that lie in the cells which somebody says they lie
  /// in. From any thread, for vertices that no other is at.
  /// @param cells  by vertex; any numbers
  void locate_where_said(std::span<const skin::CellId> cells, std::size_t begin, std::size_t end);
  /// Locates all that are left, by walks from a neighbour's cell: O(n) on ordinary meshes.
  void locate_rest();
  /// @pre all are located
  std::vector<skin::SurfacePoint> take() { return std::move(points_); }

 private:
  void place(std::uint32_t v, skin::CellId start);

  const geometry::IndexedMesh& mesh_;
  const skin::SkinSurface& skin_;
  std::vector<skin::SurfacePoint> points_;
  std::vector<char> is_located_;  ///< by vertex
};

/// All at once, by walks.
std::vector<skin::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                const skin::SkinSurface& skin);

}  // namespace morskin::refine
