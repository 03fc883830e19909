#pragma once

#include <string>
#include <vector>

#include "front/sweep_observer.h"
#include "geometry/indexed_mesh.h"
#include "morse/guide.h"
#include "surface/mesh.h"

namespace morskin {

/// Watches the pipeline (pipeline.h): its first run, not those of the safety net. Nothing that it
/// is shown lives longer than the call, unless it says so.
class Observer {
 public:
  virtual ~Observer() = default;

  /// What a sweep is about to follow; it lives until the sweep has ended.
  virtual void guided(const morse::Guide&) {}
  /// Whether Mesh::births is to be recorded.
  virtual bool wants_births() { return false; }
  /// Who is to watch a sweep from one front, for as long as it takes.
  virtual std::vector<front::SweepObserver*> sweep_observers() { return {}; }
  /// The mesh as it was swept. It may have open edges.
  virtual void swept(const surface::Mesh&) {}
  /// The mesh as it was refined, before any vertex is moved.
  virtual void refined(const surface::Mesh&) {}

  /// A mesh on its way to those who will read it.
  struct Delivery {
    geometry::IndexedMesh mesh;  ///< as they will read it
    std::string defect;          ///< what kept it from arriving whole; empty if nothing did
  };
  /// Delivers a finished mesh. What arrives is certified in its place; where that fails, a mended
  /// mesh may be delivered once more.
  virtual Delivery deliver(geometry::IndexedMesh mesh) { return {std::move(mesh), {}}; }
};

}  // namespace morskin
