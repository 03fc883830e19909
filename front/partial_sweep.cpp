#include "front/partial_sweep.h"

#include <utility>

namespace morskin::front {

PartialSweep::PartialSweep(const surface::Surface& surface, const morse::Guide& guide,
                           const SweepOptions& options,
                           const std::optional<CoarseningOptions>& coarsening,
                           const std::vector<SweepObserver*>& observers)
    : counter_(guide),
      coarsening_(
          coarsening ? std::optional<CoarseningObserver>(std::in_place, surface, *coarsening, mesh_)
                     : std::nullopt),
      sweep_(surface, guide, options, mesh_, all_observers(observers)) {}

std::vector<SweepObserver*> PartialSweep::all_observers(const std::vector<SweepObserver*>& others) {
  std::vector<SweepObserver*> all{&counter_};
  if (coarsening_) all.push_back(&*coarsening_);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

void PartialSweep::absorb(PartialSweep& other) {
  const IdOffsets offsets = sweep_.absorb(other.sweep_);
  counter_.absorb(other.counter_, offsets.edges);
  if (coarsening_) coarsening_->absorb(*other.coarsening_);
}

SweepResult PartialSweep::take_result() {
  SweepResult result;
  result.mesh = std::move(mesh_);
  result.operations = counter_.operations();
  if (coarsening_) result.operations.coarsen = coarsening_->removed();
  result.open_edges = sweep_.open_edges();
  result.triangles_laid = sweep_.triangles_laid();
  return result;
}

}  // namespace morskin::front
