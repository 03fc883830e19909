#pragma once

#include "front/sweep_observer.h"
#include "refine/coarsening.h"
#include "surface/surface.h"

namespace morskin::front {

struct CoarseningOptions {
  certify::Sizing sizing;                            ///< what the mesh is to be coarsened to
  std::size_t min_triangles = std::size_t{1} << 19;  ///< new ones that are worth a run
};

/// Coarsens the mesh behind the front, so that the whole of a fine mesh is never there at once
/// (papers/4.3-large-molecules.md).
class CoarseningObserver : public SweepObserver {
 public:
  /// @param mesh  of the sweep; must outlive the observer
  CoarseningObserver(const surface::Surface& surface, const CoarseningOptions& options, Mesh& mesh);

  void between_departures(Front& front) override {
    if (mesh_.surface.triangle_count() >= next_run_) coarsen(front);
  }
  void finished(Front& front) override { coarsen(front); }
  void absorb(const CoarseningObserver& other) { removed_ += other.removed_; }
  /// Vertices taken out.
  std::size_t removed() const { return removed_; }

 private:
  void coarsen(Front& front);

  Mesh& mesh_;
  refine::Coarsening coarsening_;
  std::size_t min_triangles_;
  std::size_t next_run_;  ///< triangles there must be
  std::size_t removed_ = 0;
};

}  // namespace morskin::front
