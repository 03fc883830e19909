#pragma once

/// The seams of a recorded sweep: where the front touched another or itself, and the gap between
/// the two sides was closed.

#include <cstdint>
#include <vector>

#include "front/sweep_observer.h"

namespace morskin::figures {

/// What met where a triangle was laid.
enum class Seam : std::uint8_t { None, TwoFronts, OneFront };

/// Notes which triangles lie on seams. After a touch two front edges run across the gap, from one
/// side to the other. A corner between such an edge and one along a side closes to an edge across,
/// a corner between two to an edge along a side. A new vertex is of neither side: there the gap is
/// no more. What closes an edge across lies on the seam.
class SeamObserver : public front::SweepObserver {
 public:
  /// @pre the mesh records births
  void follow(const front::FrontChange& change) override;
  /// By the births of triangles; those beyond the end lie on none.
  const std::vector<Seam>& by_birth() const { return by_birth_; }
  /// Forgets all, for another sweep.
  void clear() { by_birth_.clear(); }

 private:
  Seam& across(front::FrontEdgeId e);
  void note(const front::Front& front, Seam seam);

  std::vector<Seam> by_birth_;
  geometry::IdVector<front::FrontEdgeId, Seam> across_;  ///< of edges across a gap
};

}  // namespace morskin::figures
