#pragma once

/// Line 14 of Algorithm 1: refinement in the loop.
///
/// After each step of a sweep from one front, refines the mesh behind it. The stars of the front's
/// vertices stay as they are: the front remembers the half-edges that it runs along, and
/// contracting one of its vertices would take front edges away. So a new triangle is refined when
/// its last corner leaves the front, and a short front edge is contracted then. The sweep reads
/// nothing behind these stars.

#include <vector>

#include "front/sweep_observer.h"
#include "refine/local_operations.h"

namespace morskin::ablation {

class RefiningObserver : public front::SweepObserver {
 public:
  /// @param mesh  of the sweep; must outlive the observer
  RefiningObserver(const surface::Surface& surface, const certify::Sizing& sizing,
                   surface::Mesh& mesh)
      : surface_(surface), sizing_(sizing), mesh_(mesh), left_(surface, sizing, mesh) {}

  void follow(const front::FrontChange& change) override;
  void between_departures(front::Front&) override {
    if (!leaving_.empty()) refine_behind();
  }
  void finished(front::Front&) override;

 private:
  static constexpr geometry::Part behind = 0;  ///< the front: the part of its own vertices is none

  void resize();
  void refine_behind();
  void take_back();
  void defer_refused();
  void inspect(refine::LocalOperations& operations, const geometry::Subdomain& subdomain);
  void contract(refine::LocalOperations& operations, const geometry::Subdomain& subdomain) const;

  const surface::Surface& surface_;
  const certify::Sizing sizing_;
  surface::Mesh& mesh_;
  geometry::IdVector<geometry::VertexId, int> front_edges_;  ///< by vertex, that start from it
  std::vector<geometry::VertexId> leaving_;                  ///< vertices that have left the front
  geometry::Parts parts_;
  std::vector<geometry::TriangleId> refused_;  ///< big triangles, until they are tried again
  std::size_t steps_ = 0;
  refine::LocalOperations left_;  ///< what could not be done so far, and what was
};

}  // namespace morskin::ablation
