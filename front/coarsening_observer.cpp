#include "front/coarsening_observer.h"

#include <algorithm>

namespace morskin::front {

CoarseningObserver::CoarseningObserver(const surface::Surface& surface,
                                       const CoarseningOptions& options, Mesh& mesh)
    : mesh_(mesh),
      coarsening_(surface, options.sizing, mesh),
      min_triangles_(options.min_triangles),
      next_run_(options.min_triangles) {}

void CoarseningObserver::coarsen(Front& front) {
  removed_ += coarsening_.run(front.marked_vertices());
  const geometry::SurfaceMesh::Renaming renaming = mesh_.compact();
  front.rename(renaming);
  coarsening_.rename(renaming);
  const std::size_t count = mesh_.surface.triangle_count();
  next_run_ = count + std::max(min_triangles_, count / 4);
}

void CoarseningObserver::absorb(const CoarseningObserver& other, std::uint32_t vertex_offset) {
  coarsening_.take_over(other.coarsening_, vertex_offset);
  removed_ += other.removed_;
}

}  // namespace morskin::front
