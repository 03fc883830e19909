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
  geometry::Parts parts = front.parts_behind();
  removed_ += coarsening_.run({parts, 0});
  mesh_.surface.compact();
  const std::size_t count = mesh_.surface.triangle_count();
  next_run_ = count + std::max(min_triangles_, count / 4);
}

}  // namespace morskin::front
