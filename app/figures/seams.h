#pragma once

/// The seams of a recorded sweep: where two fronts touched, and the gap between them was closed.

#include <vector>

#include "front/sweep_observer.h"

namespace morskin::figures {

/// Notes which triangles lie on seams. A touch that joins two polygons leaves two front edges
/// across the gap between them. A corner between such an edge and one along a side closes to an
/// edge across, a corner between two to an edge along a side. A new vertex is of neither side:
/// there the gap is no more. What closes an edge across lies on the seam.
class SeamObserver : public front::SweepObserver {
 public:
  /// @pre the mesh records births
  void follow(const front::FrontChange& change) override;
  /// By the births of triangles; those beyond the end lie on none.
  const std::vector<bool>& by_birth() const { return by_birth_; }
  /// Forgets all, for another sweep.
  void clear() {
    by_birth_.clear();
    is_across_.clear();
  }

 private:
  bool is_across(front::FrontEdgeId e) const {
    return e.index() < is_across_.size() && is_across_[e.index()];
  }
  void set_across(front::FrontEdgeId e, bool is_across);
  void note_last_triangle(const front::Front& front);

  std::vector<bool> by_birth_;
  std::vector<bool> is_across_;  ///< by edge
};

}  // namespace morskin::figures
