#pragma once

#include <optional>
#include <span>
#include <vector>

#include "front/coarsening_observer.h"
#include "front/operation_counter.h"
#include "front/sweep.h"
#include "surface/surface.h"

namespace morskin::front {

struct SweepResult {
  surface::Mesh mesh;
  Operations operations;
  std::size_t open_edges = 0;  ///< 0 when the mesh is closed
  std::size_t subdomains = 1;
  std::size_t triangles_laid = 0;
  std::size_t seam_triangles = 0;  ///< of these, those between subdomains
};

/// One of the sweeps that mesh a surface together, each in a region of its own, with its mesh, its
/// counts and its coarsening. Absorbing is associative, so any number of them are a fold; the gap
/// between them is swept by the one that has absorbed both.
class PartialSweep {
 public:
  /// @param coarsening  nothing to leave the mesh as fine as it is laid
  /// @param observers   further ones; with surface and guide they must outlive this
  PartialSweep(const surface::Surface& surface, const morse::Guide& guide,
               const SweepOptions& options, const std::optional<CoarseningOptions>& coarsening = {},
               const std::vector<SweepObserver*>& observers = {});

  /// Makes room for so many vertices, and twice as many triangles.
  void reserve(std::size_t vertices) { mesh_.surface.reserve(vertices); }
  void run(const SweepRegion& region, std::span<const SurfacePoint> bowls) {
    sweep_.run(region, bowls);
  }
  /// @pre both have run, over disjoint regions
  void absorb(PartialSweep& other);
  std::size_t triangles_laid() const { return sweep_.triangles_laid(); }
  /// The mesh, moved out, and the counts.
  SweepResult take_result();

 private:
  std::vector<SweepObserver*> all_observers(const std::vector<SweepObserver*>& others);

  Mesh mesh_;
  OperationCounter counter_;
  std::optional<CoarseningObserver> coarsening_;
  Sweep sweep_;
};

}  // namespace morskin::front
