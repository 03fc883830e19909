#pragma once

#include <span>
#include <string>
#include <vector>

#include "certify/sizing.h"
#include "front/sweep_observer.h"
#include "geometry/indexed_mesh.h"
#include "morse/guide.h"
#include "surface/mesh.h"

namespace morskin {

/// Observes the first run of the pipeline (pipeline.h), not those of the safety net. Arguments of a
/// callback live for the call only, unless stated otherwise.
class Observer {
 public:
  virtual ~Observer() = default;

  /// The sizing of the mesh that is made next. A size goal may take several, and the last counts.
  virtual void sized(const certify::Sizing&) {}
  /// The guide of a sweep that is about to start; it lives until the sweep has ended.
  virtual void guided(const morse::Guide&) {}
  /// Whether Mesh::births is to be recorded.
  virtual bool wants_births() { return false; }
  /// The observers of a sweep from one front; they outlive it.
  virtual std::vector<front::SweepObserver*> sweep_observers() { return {}; }
  /// The mesh as it was swept. It may have open edges.
  virtual void swept(const surface::Mesh&) {}
  /// The mesh that is about to be delivered, triangle by triangle. It has no births where it was
  /// made anew in space (method.h).
  virtual void finished(const surface::Mesh&) {}

  /// A mesh as its readers get it.
  struct Delivery {
    geometry::IndexedMesh mesh;
    std::string defect;  ///< why it did not arrive whole; empty if it did
  };
  /// Delivers a finished mesh. The delivered mesh is certified; if that fails, a mended one may be
  /// delivered in its place.
  /// @param cells  by vertex, the mixed cell it lies in
  virtual Delivery deliver(geometry::IndexedMesh mesh, std::span<const geometry::CellId> cells) {
    static_cast<void>(cells);
    return {std::move(mesh), {}};
  }
};

}  // namespace morskin
